#include <array>
#include <cmath>
#include <string>

#include "checks.hpp"
#include "linearised.hpp"

namespace verify::stability {
namespace {

/// What is said of one region, counted.
struct Count {
  int cases = 0;
  int wrong = 0;
  int undecided = 0;  ///< real part within the error of the linearisation
};

/// Of an eigenvalue of the linearisation, relative to the largest. (The matrix is good to 1e-8 of a row in
/// the worst case; its error is mostly in ε, which does not move the boundary.)
constexpr double noise = 1e-11;

/// Shapes on a grid that keeps clear of the borders h/r = 1 and h/r = I_1/I_3.
constexpr std::array shapes_h = {0.15, 0.4, 0.6, 0.8, 0.95, 1.05, 1.25, 1.6, 2.1, 2.8, 3.7, 4.9};
constexpr std::array shapes_i = {0.1, 0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7, 1.9};

void count(const Setting& s, double spin, bool stable, Count& c) {
  const auto all = modes(linearised(s, spin)).eigenvalue;
  double size = 0;
  for (const Complex& x : all) size = std::max(size, std::abs(x));
  ++c.cases;
  if (std::abs(all[0].real()) <= noise * size) {
    ++c.undecided;
  } else if ((all[0].real() < 0) != stable) {
    ++c.wrong;
  }
}

}  // namespace

void check_regions(Record& record) {
  std::array<Count, 4> counts;
  int misplaced = 0;
  for (const double x : shapes_h) {
    for (const double y : shapes_i) {
      Setting s = top_of_shape(x, y);
      s.drilling = false;
      // As the paper describes them.
      const bool inner = x < 1, below = x < 1 / y;
      const std::size_t region = inner ? (below ? 3 : 2) : (below ? 0 : 1);
      constexpr std::array names = {contensou::MagnusRegion::i, contensou::MagnusRegion::ii,
                                    contensou::MagnusRegion::iii, contensou::MagnusRegion::iv};
      if (contensou::magnus_region(position(s)) != names[region]) ++misplaced;
      const double pendulum = std::sqrt(std::abs(s.a()) * s.weight() / s.top.i1);
      for (const double radius : {1e-5, 5e-4, 5e-3}) {
        s.radius = radius;
        if (region == 0 || region == 2) {
          for (const double times : {0.1, 0.3, 1.0, 3.0, 10.0})
            count(s, times * pendulum, region == 2, counts[region]);
        } else {
          // (5.35), written out.
          const double ratio = s.r() / s.h();
          const double critical =
              std::sqrt(-s.a() * s.weight() / (ratio * s.top.i1 * (s.top.i3 / s.top.i1 - ratio)));
          for (const double times : {0.2, 0.7, 0.98, 1.02, 1.4, 5.0})
            count(s, times * critical, (times > 1) == (region == 1), counts[region]);
        }
      }
    }
  }
  constexpr std::array said = {"unstable at every spin", "stable above the critical spin, unstable below it",
                               "stable at every spin but 0",
                               "stable below the critical spin, unstable above it"};
  constexpr std::array numerals = {"I", "II", "III", "IV"};
  constexpr std::array ids = {"i", "ii", "iii", "iv"};
  for (std::size_t k = 0; k < 4; ++k) {
    const Count& c = counts[k];
    const double wrong = c.wrong + c.undecided;
    record.add(Claim{std::string("stability.region.") + ids[k],
                     std::string("LG03 5.5, Region ") + numerals[k],
                     std::string(said[k]) + ", R = 1e-5, 5e-4, 5e-3 m: cases of " + std::to_string(c.cases) +
                         " where the nonlinear top, linearised without drilling torque, is not",
                     0, wrong, wrong, 0, true});
  }
  record.add(Claim{"stability.regions", "LG03 Fig. 11", "tops that the library puts into another region", 0,
                   static_cast<double>(misplaced), static_cast<double>(misplaced), 0, true});
}

}  // namespace verify::stability
