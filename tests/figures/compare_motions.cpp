// The motions of Figures 9, 10 and 12 against the stored reference motions (quadruple precision, their own
// equations, reference_data/generate/motion/).
//
//   compare_motions FIGURE FRESH REFERENCE       e.g. compare_motions fig09 /tmp/fresh reference_data/motions
//
// Allowed is what errors of the steps can become until then. The reference tells it: `spread` is the largest
// change of a value when each component of the state is off by ±1 (in its scale, at random) every
// millisecond. The integrator takes at most a step a millisecond, whose error has a root mean square of at
// most its tolerance over at most 16 components:
//     √16 tolerance.
// Errors of different nutations point in random directions, as those of the spread do; those within one (40
// ms and longer while the top is fast; 80 taken) may all point in one: times √80. To this come the error bar
// of the reference, rounding, and the error of one step that the sample itself carries: the distance of a
// closed contact has no other.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "contensou/output/table.hpp"

namespace {

namespace fs = std::filesystem;
using contensou::Table;

constexpr double tolerance = 1e-12;  // reproduce/common/tippe_top_motion.hpp
constexpr double components = 16, coherent = 80;
constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();  // of a few operations

constexpr double length = 0.021;  // from the centre of mass to the far side [m]

struct Allowed {
  double scale;  ///< of the value

  double at(double error, double spread) const {
    return error + tolerance * std::sqrt(components * coherent) * spread +
           (rounding + tolerance * std::sqrt(components)) * scale;
  }
};

// Of the reference.
double accumulation(const Table& events) {
  const auto names = events.texts("event");
  const auto at = std::find(names.begin(), names.end(), "accumulation");
  return at == names.end() ? std::numeric_limits<double>::infinity()
                           : events.numbers("t").at(static_cast<std::size_t>(at - names.begin()));
}

class Verdict {
 public:
  void add(double error, double bound, double t) {
    const double share = error / bound;
    ++count_;
    if (!(share <= 1)) ++failures_;
    if (!(share <= worst_)) {
      worst_ = share;
      error_ = error;
      t_ = t;
    }
    largest_ = std::max(largest_, error);
  }
  bool say(const std::string& what) const {
    const bool good = failures_ == 0 && count_ > 0;
    std::printf("%-32s %s: %d values, largest error %.2g; at most %.2g of what is allowed (%.2g, t = %g s)\n",
                what.c_str(), good ? "good" : "BAD", count_, largest_, worst_, error_, t_);
    return good;
  }

 private:
  int count_ = 0, failures_ = 0;
  double worst_ = -1, error_ = 0, largest_ = 0, t_ = 0;
};

// Every sample of the reference is one of the figure's; of a detail, those within it.
enum class Extent { whole, detail };
bool same_curve(const Table& fresh, const std::string& column, const Table& reference,
                const std::string& quantity, const Allowed& allowed, Extent extent = Extent::whole) {
  const auto t = fresh.numbers("t"), x = fresh.numbers(column);
  const auto at = reference.numbers("t"), expected = reference.numbers(quantity),
             error = reference.numbers(quantity + "_error"), spread = reference.numbers(quantity + "_spread");
  Verdict verdict;
  std::size_t k = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (extent == Extent::detail && (at[i] < t.front() || at[i] > t.back())) continue;
    while (k < t.size() && t[k] < at[i] - 1e-9) ++k;
    const bool there = k < t.size() && std::abs(t[k] - at[i]) < 1e-9;
    verdict.add(there ? std::abs(x[k] - expected[i]) : NAN, allowed.at(error[i], spread[i]), at[i]);
  }
  return verdict.say(column + " " + quantity);
}

// The same events in the same order at the same times, as far as the reference goes.
bool same_events(const Table& fresh, const std::string& run, const Table& reference, double until) {
  const Allowed allowed{0.04};  // a nutation
  struct Event {
    double t;
    std::string name;
  };
  const auto list = [until](const Table& table, const std::string& only) {
    const auto t = table.numbers("t");
    const auto event = table.texts("event"), contact = table.texts("contact");
    std::vector<Event> events;
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (t[i] > until || (!only.empty() && table.texts("run")[i] != only)) continue;
      events.push_back({t[i], event[i] + " " + contact[i]});
    }
    return events;
  };
  auto ours = list(fresh, run), theirs = list(reference, "");
  const auto error = reference.numbers("t_error"), spread = reference.numbers("t_spread");
  Verdict verdict;
  if (ours.size() != theirs.size()) {
    std::printf("%s: %zu events, reference %zu\n", run.c_str(), ours.size(), theirs.size());
    return false;
  }
  // Of what happens at one time the order means nothing.
  const auto sort = [](std::vector<Event>& events) {
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      if (events[i].t == events[i + 1].t && events[i + 1].name < events[i].name)
        std::swap(events[i], events[i + 1]);
    }
  };
  sort(ours);
  sort(theirs);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool same = ours[i].name == theirs[i].name;
    if (!same)
      std::printf("%s: %s at %.9g, reference %s at %.9g\n", run.c_str(), ours[i].name.c_str(), ours[i].t,
                  theirs[i].name.c_str(), theirs[i].t);
    verdict.add(same ? std::abs(ours[i].t - theirs[i].t) : NAN, allowed.at(error[i], spread[i]), theirs[i].t);
  }
  return verdict.say(run + " events");
}

// Impacts of the rocking: when they were, and how long each contact then was in the air.
bool same_impacts(const Table& fresh, const Table& reference) {
  const double end = accumulation(reference);
  const auto t = fresh.numbers("t"), next = fresh.numbers("until_next"), left = fresh.numbers("until_end");
  const auto contact = fresh.texts("contact"), event = reference.texts("event"),
             contacts = reference.texts("contact");
  const auto times = reference.numbers("t"), error = reference.numbers("t_error"),
             spread = reference.numbers("t_spread");
  const Allowed allowed{0.04};
  Verdict verdict;
  std::size_t k = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (event[i] != "close" || times[i] < t.front() - 1e-3 || times[i] > end) continue;
    const bool there = k < t.size() && contact[k] == contacts[i];
    const double bound = allowed.at(error[i], spread[i]);
    verdict.add(there ? std::abs(t[k] - times[i]) : NAN, bound, times[i]);
    verdict.add(there ? std::abs(t[k] + left[k] - end) : NAN, bound, times[i]);
    if (there && k + 1 < t.size()) verdict.add(std::abs(t[k] + next[k] - t[k + 1]), 4 * rounding, times[i]);
    ++k;
  }
  return verdict.say("impacts");
}

// θ of the animation's axes.
bool same_attitudes(const Table& motion, const Table& reference, const Allowed& allowed) {
  Table theta{{}, {"t", "theta"}, {}};
  const auto t = motion.numbers("t"), x = motion.numbers("axis_x"), y = motion.numbers("axis_y"),
             z = motion.numbers("axis_z");
  for (std::size_t i = 0; i < t.size(); ++i) theta.add({t[i], std::atan2(std::hypot(x[i], y[i]), z[i])});
  return same_curve(theta, "theta", reference, "theta", allowed);
}

bool figure_holds(const std::string& figure, const fs::path& fresh, const fs::path& reference) {
  const auto motion = [&](const std::string& name) {
    return contensou::read_table(reference / ("tippe_top_" + name + ".tsv"));
  };
  const Table curve = contensou::read_table(fresh / (figure + ".tsv"));
  const Table hertz = motion("hertz_5e-4"), hertz_events = motion("hertz_5e-4_events");
  if (figure == "animation") return same_attitudes(curve, hertz, {4});
  if (figure == "fig10") {
    const Allowed allowed{2 * length};  // z and a cosθ
    const Table rocking = contensou::read_table(fresh / "fig10_rocking.tsv");
    bool good = same_impacts(contensou::read_table(fresh / "fig10_impacts.tsv"), hertz_events);
    for (const std::string contact : {"body", "tip"}) {
      good = same_curve(curve, contact, hertz, "gap_" + contact, allowed) && good;
      good = same_curve(rocking, contact, hertz, "gap_" + contact, allowed, Extent::detail) && good;
    }
    return good;
  }
  const Table events = contensou::read_table(fresh / (figure + "_events.tsv"));
  bool good = true;
  for (std::size_t j = 1; j < curve.columns.size(); ++j) {
    const std::string& run = curve.columns[j];
    const std::string name = figure == "fig09" ? run + "_5e-4" : "hertz_" + run;
    const Table expected = motion(name);
    const Table happened = motion(name + "_events");
    good = same_curve(curve, run, expected, "theta", {4}) && good;
    if (figure == "fig09") {
      const Table near = contensou::read_table(fresh / "fig09_nutation.tsv");
      good = same_curve(near, run, expected, "theta", {4}, Extent::detail) && good;
    }
    good = same_events(events, run, happened, expected.numbers("t").back()) && good;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: compare_motions FIGURE FRESH REFERENCE\n");
    return 2;
  }
  try {
    return figure_holds(argv[1], argv[2], argv[3]) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_motions: %s\n", error.what());
    return 1;
  }
}
