// Reference curves and event times of the tippe-top, reference_data/motions/*.tsv. Shares no code with the
// library.
//
//   tippe_top_curves FOLDER [MOTION]     writes the tables, in quadruple precision: minutes
//   tippe_top_curves --check FOLDER      goes through the motions in extended precision, and fails where one
//                                        leaves the error bars of the tables in FOLDER: seconds

#include <boost/multiprecision/float128.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tippe_top.hpp"

namespace {

using namespace reference;
using Extended = long double;
using Quadruple = boost::multiprecision::float128;

struct Motion {
  const char* name;
  Pressure pressure;
  int inverse_radius;  ///< 1/R [1/m]
  int milliseconds;
};
// R = 10⁻³ m ends before the contact comes to rest, R = 10⁻⁵ m is of no figure.
constexpr Motion motions[] = {{"tippe_top_hertz_5e-4", Pressure::hertz, 2000, 8000},
                              {"tippe_top_uniform_5e-4", Pressure::uniform, 2000, 8000},
                              {"tippe_top_hertz_1e-4", Pressure::hertz, 10000, 8000},
                              {"tippe_top_hertz_2e-5", Pressure::hertz, 50000, 8000},
                              {"tippe_top_hertz_1e-3", Pressure::hertz, 1000, 5000}};

constexpr int sample = 20;                // [ms]
constexpr double extended_error = 1e-16;  // of a step, in units of scales: rounding is 1e-19
constexpr double quadruple_error = 1e-20;
using Checking = TippeTopMotion<Extended, 9>;
using Storing = TippeTopMotion<Quadruple, 14>;

// The largest of so many runs, each with errors of `kick` every millisecond.
constexpr int perturbed_runs = 16;
constexpr double kick = 1e-13, kicked_error = 1e-15;

struct Run {
  std::vector<Seen<Extended>> seen;
  std::vector<Happening<Extended>> events;
};

Seen<Extended> rounded(const Seen<Quadruple>& s) {
  return {Extended(s.t), Extended(s.theta), Extended(s.gap_body), Extended(s.gap_tip)};
}
Seen<Extended> rounded(const Seen<Extended>& s) { return s; }

template <class Top>
Run run(Top& top, const Motion& motion, double kicks) {
  using Real = typename Top::State::value_type;
  Run result;
  for (int k = 0; k <= motion.milliseconds; ++k) {
    if (kicks > 0 || k % sample == 0) top.advance(Real(k) / 1000);
    if (k % sample == 0) result.seen.push_back(rounded(top.seen()));
    if (kicks > 0) top.perturb(Real(kicks));
  }
  for (const auto& e : top.events()) result.events.push_back({Extended(e.t), e.event, e.contact});
  return result;
}

template <class Top>
Run run(const Motion& motion, double error, double kicks = 0, int seed = 0) {
  using Real = typename Top::State::value_type;
  Top top(motion.pressure, 1 / Real(motion.inverse_radius), error, static_cast<std::uint64_t>(seed));
  return run(top, motion, kicks);
}

// Impacts within 10 μs of their accumulation are left out.
std::vector<Happening<Extended>> told(const std::vector<Happening<Extended>>& events) {
  Extended end = -1;
  for (const auto& e : events) {
    if (e.event == "accumulation") end = e.t;
  }
  std::vector<Happening<Extended>> list;
  for (const auto& e : events) {
    if (e.event == "accumulation" || e.t >= end || e.t < end - 1e-5L) list.push_back(e);
  }
  return list;
}

Extended magnitude(Extended x) { return x < 0 ? -x : x; }

/// What an error bar is made of: three times the difference of two precisions, not less than the rounding of
/// the digits printed, not less than before.
class Bar {
 public:
  Extended next(Extended a, Extended b) {
    bar_ = std::max(bar_, 3 * magnitude(a - b) + 1e-19L);
    return bar_;
  }

 private:
  Extended bar_ = 0;
};

std::string text(const char* format, Extended x) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}
std::string value(Extended x) { return text("%.19Lg", x); }
// Two digits, not less than x.
std::string bar(Extended x) { return text("%.1Le", x * 1.05L); }

std::string head(const Motion& motion, const char* what, const char* columns) {
  std::ostringstream out;
  out << "# The tippe-top of LG03 5.4, " << (motion.pressure == Pressure::hertz ? "Hertz" : "uniform")
      << " pressure, R = 1/" << motion.inverse_radius << " m, from the floor: " << what
      << "\n# units: s, rad, m"
         "\n# generator: reference_data/generate/motion/tippe_top_curves.cpp (Newton and Euler, "
         "extrapolation to order 28)"
         "\n# command: tippe_top_curves reference_data/motions (by hand: it takes minutes); checked by "
         "tippe_top_curves "
         "--check"
         "\n# precision: quadruple, steps to 1e-20; error: three times the difference to extended precision, "
         "order 18, "
         "steps to 1e-16, the largest until then"
         "\n# spread: by how much the value changes at most, in "
      << perturbed_runs
      << " runs, where every component of the state is off by ±1 in its scale at random every\n#   "
         "millisecond; linear, "
         "from errors of 1e-13. Scales: length a2 + r2, axis 1, energy E at the start, velocity √(2E/m), "
         "angular momentum √(2 E I1)\n"
      << columns << '\n';
  return out.str();
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

void require_same_events(const std::vector<Happening<Extended>>& a,
                         const std::vector<Happening<Extended>>& b) {
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i)
    same = a[i].event == b[i].event && a[i].contact == b[i].contact;
  if (!same) throw std::runtime_error("another sequence of events in another precision");
}

constexpr Extended Seen<Extended>::*const quantities[] = {&Seen<Extended>::theta, &Seen<Extended>::gap_body,
                                                          &Seen<Extended>::gap_tip};

void make(const Motion& motion, const std::filesystem::path& folder) {
  const Run best = run<Storing>(motion, quadruple_error);
  const Run second = run<Checking>(motion, extended_error);
  std::vector<Run> kicked;
  for (int seed = 1; seed <= perturbed_runs; ++seed)
    kicked.push_back(run<Checking>(motion, kicked_error, kick, seed));

  std::string curve =
      head(motion, "inclination and distances of the contacts",
           "t\ttheta\ttheta_error\ttheta_spread\tgap_body\tgap_body_error\tgap_body_spread\tgap_tip\t"
           "gap_tip_error\tgap_tip_spread");
  Bar bars[3];
  for (std::size_t k = 0; k < best.seen.size(); ++k) {
    curve += text("%.2Lf", best.seen[k].t);
    for (int q = 0; q < 3; ++q) {
      const auto member = quantities[q];
      const Extended x = best.seen[k].*member;
      Extended spread = 0;
      for (const Run& r : kicked)
        spread = std::max(spread, magnitude(r.seen[k].*member - second.seen[k].*member));
      curve +=
          '\t' + value(x) + '\t' + bar(bars[q].next(x, second.seen[k].*member)) + '\t' + bar(spread / kick);
    }
    curve += '\n';
  }
  write(folder / (std::string(motion.name) + ".tsv"), curve);

  const auto events = told(best.events), others = told(second.events);
  require_same_events(events, others);
  std::vector<std::vector<Happening<Extended>>> spreads;
  for (const Run& r : kicked) {
    spreads.push_back(told(r.events));
    require_same_events(events, spreads.back());
  }
  std::string list = head(motion, "events; impacts less than 1e-5 s before their accumulation left out",
                          "t\tevent\tcontact\tt_error\tt_spread");
  Bar times;
  for (std::size_t k = 0; k < events.size(); ++k) {
    Extended spread = 0;
    for (const auto& r : spreads) spread = std::max(spread, magnitude(r[k].t - others[k].t));
    list += value(events[k].t) + '\t' + events[k].event + '\t' + (events[k].contact == 0 ? "body" : "tip") +
            '\t' + bar(times.next(events[k].t, others[k].t)) + '\t' + bar(spread / kick) + '\n';
  }
  write(folder / (std::string(motion.name) + "_events.tsv"), list);
}

/// Rows of cells, without comments and names of columns.
std::vector<std::vector<std::string>> read(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, '\t');) cells.push_back(cell);
    rows.push_back(cells);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

bool check(const Motion& motion, const std::filesystem::path& folder) {
  const Run now = run<Checking>(motion, extended_error);
  const auto rows = read(folder / (std::string(motion.name) + ".tsv"));
  const auto listed = read(folder / (std::string(motion.name) + "_events.tsv"));
  const auto events = told(now.events);
  if (rows.size() != now.seen.size() || listed.size() != events.size()) {
    std::printf("%s: another number of rows\n", motion.name);
    return false;
  }
  const auto number = [](const std::string& cell) { return std::strtold(cell.c_str(), nullptr); };
  Extended worst = 0;  // in error bars
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t q = 0; q < 3; ++q) {
      const Extended off = magnitude(now.seen[k].*quantities[q] - number(rows[k].at(1 + 3 * q)));
      worst = std::max(worst, off / number(rows[k].at(2 + 3 * q)));
    }
  }
  for (std::size_t k = 0; k < events.size(); ++k) {
    worst = std::max(worst, magnitude(events[k].t - number(listed[k].at(0))) / number(listed[k].at(3)));
    if (events[k].event != listed[k].at(1)) worst = 1e300L;
  }
  std::printf("%s: at most %.2Lg of an error bar\n", motion.name, worst);
  return worst <= 1;
}

/// The slip laws in extended precision against the stored tables of interval arithmetic, u from 0 to 1e6.
bool check_law(Pressure pressure, const std::filesystem::path& table) {
  const auto number = [](const std::string& cell) { return std::strtold(cell.c_str(), nullptr); };
  const SlipLaw<Extended> law(pressure);
  Extended worst = 0;
  int count = 0;
  for (const auto& row : read(table)) {                          // u phi xi eta
    const Extended u = std::strtod(row.at(0).c_str(), nullptr);  // the double itself
    if (!(u <= 1e6L)) continue;
    const Slip<Extended> f = law.at(u, 1);
    for (const auto& [x, expected] : {std::pair{f.xi, number(row.at(2))}, {f.eta, number(row.at(3))}}) {
      if (expected > 0) worst = std::max(worst, magnitude(x - expected) / expected);
    }
    ++count;
  }
  // The elementary and elliptic forms lose two or three digits where they are used, 1/2 < u^2 < 2.
  constexpr Extended bound = 1e3L * std::numeric_limits<Extended>::epsilon();
  std::printf("%s: %d values, off by at most %.2Lg (relative)\n", table.c_str(), count, worst);
  return count > 0 && worst <= bound;
}

}  // namespace

int main(int argc, char** argv) {
  const bool checking = argc == 3 && std::string_view(argv[1]) == "--check";
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: tippe_top_curves (FOLDER [MOTION] | --check FOLDER)\n");
    return 2;
  }
  try {
    bool good = true;
    if (checking) {
      const auto laws = std::filesystem::path(argv[2]) / ".." / "laws";
      good = check_law(Pressure::hertz, laws / "hertz.tsv");
      good = check_law(Pressure::uniform, laws / "uniform.tsv") && good;
    }
    for (const Motion& motion : motions) {
      if (checking) {
        good = check(motion, argv[2]) && good;
      } else if (argc == 2 || std::string_view(argv[2]) == motion.name) {
        std::filesystem::create_directories(argv[1]);
        make(motion, argv[1]);
      }
    }
    return good ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tippe_top_curves: %s\n", error.what());
    return 1;
  }
}
