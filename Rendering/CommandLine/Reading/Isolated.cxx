// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Isolated.h"
#include "CheckCells.h"
#include "MeshPipe.h"
#include "Messages.h"
#include "Progress.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <new>
#include <sys/wait.h>
#include <unistd.h>

namespace lambent::command
{
namespace
{

/// The limit on a reader's elapsed time, as a multiple of its CPU time: waiting takes no CPU time.
constexpr unsigned long waitFactor = 12;

/// Detaches the child from the parent's signal handlers, which clean up for the parent, from the
/// standard streams, and from VTK's threads, which a child does not inherit and would wait for.
void Detach()
{
  vtkSMPTools::SetBackend("Sequential");
  for (const int signal : { SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU, SIGALRM })
  {
    std::signal(signal, SIG_DFL);
  }
  // Libraries, the C library's checks and std::terminate() print messages of no use to the user.
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
}

/// Runs in the child: reads the file and sends the result.
void ReadAndSend(const std::function<vtkSmartPointer<vtkPolyData>()>& read, int file,
  VtkMessages& messages, Progress& progress)
{
  MeshPipeWriter pipe(file);
  progress.Redirect(
    [&pipe](double fraction) { pipe.Send(MessageTag::Progress, &fraction, sizeof(fraction)); });
  try
  {
    const vtkSmartPointer<vtkPolyData> mesh = read();
    for (const std::string& warning : messages.TakeWarnings())
    {
      pipe.Send(MessageTag::Warning, warning);
    }
    pipe.Send(mesh);
    pipe.Send(MessageTag::End, "");
  }
  catch (const std::bad_alloc&)
  {
    pipe.Send(MessageTag::Error,
      "its reader asks for far more memory than a file of its size needs; check that the file is "
      "complete and has the right extension");
  }
  catch (const std::exception& reason)
  {
    pipe.Send(MessageTag::Error, reason.what());
  }
}

/// Receives the child's messages. Returns null if the child ended before its last message.
vtkSmartPointer<vtkPolyData> Receive(int file, Progress& progress)
{
  MeshPipeReader pipe(file);
  MessageTag tag;
  while (pipe.Next(tag))
  {
    switch (tag)
    {
      case MessageTag::Progress:
        progress.Update(pipe.TakeNumber());
        break;
      case MessageTag::Warning:
        vtkGenericWarningMacro(<< pipe.TakeText());
        break;
      case MessageTag::Error:
        throw Failure(pipe.TakeText());
      case MessageTag::Array:
        pipe.TakeArray();
        break;
      case MessageTag::End:
        return pipe.MakeMesh();
    }
  }
  return nullptr;
}

/// A child process. The destructor kills it, if it still runs, and waits for it.
class Child
{
public:
  Child(pid_t id, int file)
    : Id(id)
    , File(file)
  {
  }
  ~Child() { this->End(true); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits for the child, after killing it if it is unwanted. Returns its status from waitpid().
  int End(bool isUnwanted)
  {
    if (this->Id > 0)
    {
      close(this->File);
      if (isUnwanted)
      {
        kill(this->Id, SIGKILL);
      }
      while (waitpid(this->Id, &this->Status, 0) < 0 && errno == EINTR)
      {
      }
      this->Id = 0;
    }
    return this->Status;
  }

private:
  pid_t Id;
  int File;
  int Status = 0;
};

[[noreturn]] void ThrowEnd(int status, const ChildLimits& limits)
{
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const std::string advice = "; check that the file is complete and has the right extension";
  if (signal == SIGXCPU || signal == SIGALRM)
  {
    const unsigned long factor = signal == SIGALRM ? waitFactor : 1;
    throw Failure("its reader did not finish in " + std::to_string(factor * limits.seconds) +
      (signal == SIGALRM ? " seconds" : " seconds of CPU time") + advice);
  }
  if (signal == SIGKILL)
  {
    throw Failure("its reader was killed, perhaps because the machine ran out of memory" + advice);
  }
  throw Failure("its reader crashed" +
    (signal ? std::string(" (") + strsignal(signal) + ")" : std::string()) + advice);
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadIsolated(const std::function<vtkSmartPointer<vtkPolyData>()>& read,
  const ChildLimits& limits, VtkMessages& messages, Progress& progress)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw Failure(std::strerror(errno));
  }
  const pid_t id = fork();
  if (id == 0)
  {
    close(ends[0]);
    Detach();
    TakeLimits(limits);
    alarm(static_cast<unsigned int>(waitFactor * limits.seconds));
    ReadAndSend(read, ends[1], messages, progress);
    _exit(0); // skip destructors and exit handlers, which belong to the parent
  }
  close(ends[1]);
  if (id < 0)
  {
    close(ends[0]);
    throw Failure(std::string("it cannot be read in a separate process: ") + std::strerror(errno));
  }
  Child child(id, ends[0]);
  const vtkSmartPointer<vtkPolyData> mesh = Receive(ends[0], progress);
  const int status = child.End(mesh != nullptr);
  if (!mesh)
  {
    ThrowEnd(status, limits);
  }
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    CheckCells(cells, mesh->GetNumberOfPoints()); // a faulty reader may still exit normally
  }
  return mesh;
}

} // namespace lambent::command
