#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cli {

/// What there is to do for a crew.
struct SweepWork {
  std::vector<std::size_t> runs;                     ///< the leader's are those that count
  std::function<std::string(std::size_t)> compute;   ///< a run's row; called by many threads at once
  std::function<void(const std::string& row)> take;  ///< called by the leader's thread alone
  std::function<bool()> stop;                        ///< asked often, by the leader's thread: no more runs
};

/// Those who compute a sweep together: the threads of this process, or the processes of an MPI job.
class SweepCrew {
 public:
  SweepCrew() = default;
  virtual ~SweepCrew() = default;
  SweepCrew(const SweepCrew&) = delete;
  SweepCrew& operator=(const SweepCrew&) = delete;

  /// Whether this process has the file and speaks to the user.
  virtual bool leads() const = 0;
  /// What anybody has to complain of, for everybody: `complaint` of the first process that has one.
  virtual std::string agree(const std::string& complaint) = 0;
  /// Computes the leader's runs, each once, in no order, until all are done or stop() says so; then those
  /// that were begun are finished and taken. What take() throws ends it likewise, and is thrown at the end.
  virtual void share(const SweepWork& work) = 0;
};

/// `jobs` threads of this process.
std::unique_ptr<SweepCrew> threads_crew(unsigned jobs);

/// The processes of the MPI job that this one was started in, one run at a time each. Null where the program
/// was built without MPI.
std::unique_ptr<SweepCrew> ranks_crew();

/// What the environment says of an MPI job (mpirun of Open MPI, any launcher that speaks PMIx), before MPI is
/// asked: a program that was not started as a part of one never calls it.
struct MpiJob {
  bool several = false;  ///< whether there is more than one process
  bool first = true;     ///< whether this is the first of them
};
MpiJob mpi_job();

}  // namespace cli
