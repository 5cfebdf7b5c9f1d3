// The one place that knows MPI: the processes of a job compute a sweep together. The first has the file,
// hands out the runs and computes, too; its main thread alone speaks MPI.
#include <cstdlib>

#include "sweep_crew.hpp"

#ifdef CONTENSOU_MPI
#define OMPI_SKIP_MPICXX 1  // the C interface alone
#include <mpi.h>

#include <cstdint>
#include <limits>

#include "sweep_workers.hpp"
#endif

namespace cli {

MpiJob mpi_job() {
  const char* const open_mpi_size = std::getenv("OMPI_COMM_WORLD_SIZE");
  const char* const open_mpi_rank = std::getenv("OMPI_COMM_WORLD_RANK");
  const char* const pmix_rank = std::getenv("PMIX_RANK");
  const char* const rank = open_mpi_rank != nullptr ? open_mpi_rank : pmix_rank;
  // PMIx does not say how many; MPI then will.
  const bool several = open_mpi_size != nullptr ? std::string(open_mpi_size) != "1" : pmix_rank != nullptr;
  return {several, rank == nullptr || std::string(rank) == "0"};
}

#ifdef CONTENSOU_MPI
namespace {

constexpr std::uint64_t no_more = std::numeric_limits<std::uint64_t>::max();
enum Tag : int { row_tag, run_tag };

class RanksCrew : public SweepCrew {
 public:
  RanksCrew() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);  // errors end the job: MPI's default
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~RanksCrew() override { MPI_Finalize(); }

  bool leads() const override { return rank_ == 0; }

  std::string agree(const std::string& complaint) override {
    const int mine = complaint.empty() ? size_ : rank_;
    int first = 0;
    MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (first == size_) return {};
    std::string text = complaint;
    auto length = static_cast<std::uint64_t>(text.size());
    MPI_Bcast(&length, 1, MPI_UINT64_T, first, MPI_COMM_WORLD);
    text.resize(length);
    MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, first, MPI_COMM_WORLD);
    return text;
  }

  void share(const SweepWork& work) override { leads() ? lead(work) : follow(work); }

 private:
  void lead(const SweepWork& work) const {
    constexpr std::chrono::microseconds patience(200);  // how long another process may wait for its next run
    RunsLeft runs(work.runs);
    SweepWorkers own(1, runs, work.compute);
    Taker taker(work, runs);
    for (int others = size_ - 1; others > 0 || !own.finished();) {
      taker.look_for_stop();
      while (answer_one(taker, runs, others)) {
      }
      if (own.finished()) {
        std::this_thread::sleep_for(patience);
      } else if (const auto row = own.row(patience)) {
        taker.take(*row);
      }
    }
    taker.finish();
  }

  /// Takes a row from another process and sends it the next run, if one is waiting.
  static bool answer_one(Taker& taker, RunsLeft& runs, int& others) {
    int waiting = 0, length = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, row_tag, MPI_COMM_WORLD, &waiting, &status);
    if (waiting == 0) return false;
    MPI_Get_count(&status, MPI_CHAR, &length);
    std::string row(static_cast<std::size_t>(length), '\0');
    MPI_Recv(row.data(), length, MPI_CHAR, status.MPI_SOURCE, row_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const std::uint64_t run = runs.next().value_or(no_more);
    MPI_Send(&run, 1, MPI_UINT64_T, status.MPI_SOURCE, run_tag, MPI_COMM_WORLD);
    if (run == no_more) --others;
    if (!row.empty()) taker.take(row);
    return true;
  }

  static void follow(const SweepWork& work) {
    std::string row;  // the first is empty: only asks
    for (;;) {
      MPI_Send(row.data(), static_cast<int>(row.size()), MPI_CHAR, 0, row_tag, MPI_COMM_WORLD);
      std::uint64_t run = no_more;
      MPI_Recv(&run, 1, MPI_UINT64_T, 0, run_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      if (run == no_more) return;
      row = work.compute(static_cast<std::size_t>(run));
    }
  }

  int rank_ = 0;
  int size_ = 1;
};

}  // namespace

std::unique_ptr<SweepCrew> ranks_crew() { return std::make_unique<RanksCrew>(); }
#else
std::unique_ptr<SweepCrew> ranks_crew() { return nullptr; }
#endif

}  // namespace cli
