// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the interface to the caller's threads, and parallel loops
 *
 * The core starts no threads. The caller supplies a Parallel, which runs a body once
 * for each worker. The core distributes the work: each worker takes the next chunk
 * until none is left, so no worker idles while there is work. Which worker gets which
 * chunk varies from run to run; no result of the core may depend on it.
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
/// Runs everything in the calling thread. Override workers() and run() to use more threads.
class Parallel
{
public:
  virtual ~Parallel() = default;
  /// The number of workers of run(), at least 1.
  virtual int workers() const { return 1; }
  /// Calls body(worker) once for each worker, concurrently or in turn, and returns when all
  /// calls have returned. The body must not throw.
  virtual void run(const std::function<void(int worker)>& body) const { body(0); }
  /// The thread that started the work calls this between parts, with the fraction done so far.
  /// It may throw to abort the work.
  virtual void checkpoint(double /*done*/) const {}
};

/**
 * Calls body(worker, i) once for each i in [begin, end), in any order. A single item runs in the
 * calling thread, since waking another takes longer than most bodies. After an exception no
 * further items are started, and the exception is rethrown to the caller.
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
