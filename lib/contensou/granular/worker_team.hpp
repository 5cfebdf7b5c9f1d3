#pragma once

#include <barrier>
#include <thread>
#include <vector>

namespace contensou {

/// Threads that work on one thing together: the caller and size() − 1 others, which sleep in between.
class WorkerTeam {
 public:
  /// size >= 1; one is the caller alone, and no thread is made.
  explicit WorkerTeam(int size);
  ~WorkerTeam();
  WorkerTeam(const WorkerTeam&) = delete;
  WorkerTeam& operator=(const WorkerTeam&) = delete;

  int size() const { return size_; }

  /// Calls work(k) in each worker k = 0 to size() − 1 and returns when all have returned; the caller is
  /// worker 0. `work` must not throw.
  template <class Work>
  void run(Work&& work) {
    if (size_ == 1) return work(0);
    work_ = &work;
    call_ = [](void* self, int worker) { (*static_cast<std::remove_reference_t<Work>*>(self))(worker); };
    barrier_.arrive_and_wait();
    work(0);
    barrier_.arrive_and_wait();
  }
  /// Inside work: waits until all workers are here.
  void meet() {
    if (size_ > 1) barrier_.arrive_and_wait();
  }

 private:
  void serve(int worker);

  int size_;
  void* work_ = nullptr;
  void (*call_)(void* work, int worker) = nullptr;
  bool ended_ = false;
  std::barrier<> barrier_;
  std::vector<std::thread> threads_;
};

}  // namespace contensou
