#include "sweep_workers.hpp"

#include <utility>

namespace cli {
namespace {

class ThreadsCrew : public SweepCrew {
 public:
  explicit ThreadsCrew(unsigned jobs) : jobs_(jobs) {}

  bool leads() const override { return true; }
  std::string agree(const std::string& complaint) override { return complaint; }
  void share(const SweepWork& work) override {
    constexpr std::chrono::milliseconds patience(50);  // how soon Ctrl-C is seen
    RunsLeft runs(work.runs);
    SweepWorkers workers(jobs_, runs, work.compute);
    Taker taker(work, runs);
    while (!workers.finished()) {
      taker.look_for_stop();
      if (const auto row = workers.row(patience)) taker.take(*row);
    }
    taker.finish();
  }

 private:
  unsigned jobs_;
};

}  // namespace

std::optional<std::size_t> RunsLeft::next() {
  const std::lock_guard lock(mutex_);
  if (begun_ == runs_.size()) return {};
  return runs_[begun_++];
}

void RunsLeft::stop() {
  const std::lock_guard lock(mutex_);
  begun_ = runs_.size();
}

SweepWorkers::SweepWorkers(unsigned count, RunsLeft& runs, const Compute& compute)
    : runs_(runs), compute_(compute), busy_(count) {
  for (unsigned i = 0; i < count; ++i) threads_.emplace_back([this] { work(); });
}

SweepWorkers::~SweepWorkers() {
  runs_.stop();
  for (std::thread& thread : threads_) thread.join();
}

void SweepWorkers::work() {
  while (const auto run = runs_.next()) {
    std::string row = compute_(*run);
    const std::lock_guard lock(mutex_);
    rows_.push(std::move(row));
    changed_.notify_one();
  }
  const std::lock_guard lock(mutex_);
  --busy_;
  changed_.notify_one();
}

std::optional<std::string> SweepWorkers::row(std::chrono::microseconds patience) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [this] { return !rows_.empty() || busy_ == 0; });
  if (rows_.empty()) return {};
  std::string row = std::move(rows_.front());
  rows_.pop();
  return row;
}

bool SweepWorkers::finished() {
  const std::lock_guard lock(mutex_);
  return busy_ == 0 && rows_.empty();
}

void Taker::take(const std::string& row) {
  if (failure_) return;
  try {
    work_.take(row);
  } catch (...) {
    failure_ = std::current_exception();
    runs_.stop();
  }
}

void Taker::look_for_stop() {
  if (work_.stop()) runs_.stop();
}

void Taker::finish() const {
  if (failure_) std::rethrow_exception(failure_);
}

std::unique_ptr<SweepCrew> threads_crew(unsigned jobs) { return std::make_unique<ThreadsCrew>(jobs); }

}  // namespace cli
