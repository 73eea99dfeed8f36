// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief disjoint sets of the numbers 0 to n - 1, ordered by their smallest members
 *
 * R. E. Tarjan, J. van Leeuwen, "Worst-Case Analysis of Set Union Algorithms", Journal of
 * the ACM 31(2), 1984. Uses path halving; the smallest member is the root.
 */
#ifndef lambent_DisjointSets_h
#define lambent_DisjointSets_h

#include <algorithm>
#include <numeric>
#include <vector>

namespace lambent
{
class DisjointSets
{
public:
  /// Puts each number into a set of its own. Reuses memory.
  void reset(int count)
  {
    this->Leaders.resize(static_cast<std::size_t>(count));
    std::iota(this->Leaders.begin(), this->Leaders.end(), 0);
  }

  void join(int a, int b)
  {
    const int leaderA = this->leader(a);
    const int leaderB = this->leader(b);
    this->Leaders[std::max(leaderA, leaderB)] = std::min(leaderA, leaderB);
  }

  /// Numbers the sets from 0 on, ordered by their smallest members. Returns how many there are.
  int number()
  {
    int sets = 0;
    this->Sets.resize(this->Leaders.size());
    for (int i = 0; i < static_cast<int>(this->Leaders.size()); ++i)
    {
      const int leader = this->leader(i); // at most i, so its set is already numbered
      this->Sets[i] = leader == i ? sets++ : this->Sets[leader];
    }
    return sets;
  }

  /// The number of the set of i, as of the last call of number().
  int set(int i) const { return this->Sets[i]; }

private:
  int leader(int i)
  {
    while (this->Leaders[i] != i)
    {
      this->Leaders[i] = this->Leaders[this->Leaders[i]];
      i = this->Leaders[i];
    }
    return i;
  }

  std::vector<int> Leaders;
  std::vector<int> Sets;
};
}

#endif
