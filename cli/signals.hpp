#pragma once

#include <csignal>
#include <ctime>

namespace cli {

/// Holds back the signals that would end the program, Ctrl-C among them, in this thread and those it starts
/// from now on; those still pending act when this is gone.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held_, signal);
    sigprocmask(SIG_BLOCK, &held_, &before_);
  }
  ~SignalsHeld() { release(); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

  /// From now on they act at once.
  void release() const { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  /// One that has come, which then acts no more; 0: none has.
  int take() const {
    const timespec now{};
    const int signal = sigtimedwait(&held_, nullptr, &now);
    return signal < 0 ? 0 : signal;
  }

 private:
  sigset_t held_;
  sigset_t before_;
};

}  // namespace cli
