#include "arguments.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "decimal.hpp"

namespace reference {

namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

double power_of_ten(int sixths) {
  constexpr long bits = 256;
  return nearest_double(pow(Ball(10.0, bits), Ball(static_cast<double>(sixths), bits) / 6.0));
}

/// splitmix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// lower..upper, both included. (The bias of the remainder is below 2^-50 here.)
  int integer(int lower, int upper) {
    return lower + static_cast<int>(bits() % static_cast<std::uint64_t>(upper - lower + 1));
  }

 private:
  std::uint64_t state_;
};

/// A multiple of 2^unit with leading bit 2^exponent, the up to 52 bits that follow it random.
double draw(Random& random, int exponent, int unit) {
  const int width = std::min(52, exponent - unit);
  const std::uint64_t fraction = width == 0 ? 0 : random.bits() >> (64 - width);
  return std::ldexp(static_cast<double>((std::uint64_t{1} << width) + fraction), exponent - width);
}

/// Where a range's numbers come from: directly (origin 0), or
/// as 1 − d, 1 + d with d a multiple of the spacing there.
enum class Around { zero, below_one, above_one };

constexpr std::size_t count = 250;

std::vector<double> fill(Around around, double first, double last, std::uint64_t seed) {
  Random random(seed);
  std::set<double> u = {first, last};
  const bool seam = around != Around::zero;
  const int unit = around == Around::zero ? -1074 : around == Around::below_one ? -53 : -52;
  const double near = around == Around::below_one   ? 1 - last
                      : around == Around::above_one ? first - 1
                                                    : first;
  const double far = around == Around::below_one ? 1 - first : around == Around::above_one ? last - 1 : last;
  while (u.size() < count) {
    const double distance = draw(random, random.integer(std::ilogb(near), std::ilogb(far)), unit);
    if (distance < near || distance > far) continue;
    u.insert(!seam ? distance : around == Around::below_one ? 1 - distance : 1 + distance);
  }
  return {u.begin(), u.end()};
}

double before(double x) { return std::nextafter(x, 0.0); }
double after(double x) { return std::nextafter(x, infinity); }

}  // namespace

std::vector<double> law_arguments() {
  std::set<double> u = {0, smallest, 1e-300, before(1), 1, after(1), 1e300, largest, infinity};
  for (int sixths = -36; sixths <= 36; ++sixths) u.insert(power_of_ten(sixths));
  for (int k = 1; k <= 52; ++k) {
    u.insert(1 - std::ldexp(1.0, -k));
    u.insert(1 + std::ldexp(1.0, -k));
  }
  return {u.begin(), u.end()};
}

std::vector<Range> accuracy_ranges() {
  return {{"tiny", "[5e-324, 1e-6)", fill(Around::zero, smallest, before(1e-6), 1)},
          {"small", "[1e-6, 0.5)", fill(Around::zero, 1e-6, before(0.5), 2)},
          {"inner", "[0.5, 0.9)", fill(Around::zero, 0.5, before(0.9), 3)},
          {"seam_in", "[0.9, 1)", fill(Around::below_one, 0.9, before(1), 4)},
          {"seam_out", "(1, 1.1]", fill(Around::above_one, after(1), 1.1, 5)},
          {"outer", "(1.1, 2]", fill(Around::zero, after(1.1), 2, 6)},
          {"large", "(2, 1e3]", fill(Around::zero, after(2), 1e3, 7)},
          {"huge", "(1e3, 1e8]", fill(Around::zero, after(1e3), 1e8, 8)},
          {"giant", "(1e8, 1.7e308]", fill(Around::zero, after(1e8), 1.7e308, 9)}};
}

}  // namespace reference
