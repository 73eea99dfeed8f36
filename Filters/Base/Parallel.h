// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief parallel loops, handed in from outside
 *
 * The core starts no threads. It is given a Parallel, which runs a body once for
 * each worker, and shares work out itself: each worker takes the next chunk until
 * there is none left, so nobody waits while there is work. Which worker gets which
 * chunk is left to chance; nothing in the core may depend on it.
 */
#ifndef lambent_Parallel_h
#define lambent_Parallel_h

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace lambent
{
/// Runs everything in the calling thread. Override the first two to run on more.
class Parallel
{
public:
  virtual ~Parallel() = default;
  /// How many workers run() has, at least 1.
  virtual int workers() const { return 1; }
  /// Calls body(worker) once for each worker, at the same time or one after the
  /// other, and returns when all have returned. The body does not throw.
  virtual void run(const std::function<void(int worker)>& body) const { body(0); }
  /// Called between the parts of long work, by the thread that asked for it, with the
  /// fraction that is done. It may throw: the work is then given up.
  virtual void checkpoint(double /*done*/) const {}
};

/**
 * Calls body(worker, i) once for each i in [begin, end), in any order; a single one in the
 * calling thread, since to wake others takes longer than most bodies. The first exception
 * stops the handing out of work and is thrown to the caller.
 */
template <typename Body>
void forEach(const Parallel& parallel, std::size_t begin, std::size_t end, Body&& body)
{
  if (end - begin <= 1)
  {
    if (begin < end)
    {
      body(0, begin);
    }
    return;
  }
  std::atomic<std::size_t> next{ begin };
  std::exception_ptr failure;
  std::mutex failureMutex;
  parallel.run(
    [&](int worker)
    {
      try
      {
        for (std::size_t i = next++; i < end; i = next++)
        {
          body(worker, i);
        }
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(failureMutex);
        failure = std::current_exception();
        next = end;
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
}

#endif
