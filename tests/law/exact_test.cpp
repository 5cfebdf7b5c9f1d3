// The exact laws against the stored tables of interval arithmetic, and at every edge of the doubles.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "contensou/law/batch.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/uniform.hpp"
#include "contensou/output/table.hpp"
#include "doubles.hpp"

using namespace contensou;
namespace fs = std::filesystem;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double eps = std::numeric_limits<double>::epsilon();

/// One row of a reference table; long double holds the 34
/// digits to 2^-64, a four-thousandth of an ulp of a double.
struct Row {
  double u;
  long double phi, xi, eta, f2;
};

std::vector<Row> reference(const std::string& file) {
  const fs::path path = fs::path(CONTENSOU_REFERENCE_DATA) / file;
  INFO(path);
  REQUIRE(fs::exists(path));
  const Table table = read_table(path);
  const auto numbers = [&](const char* column) {
    std::vector<long double> values;
    for (const std::string& text : table.texts(column)) values.push_back(std::strtold(text.c_str(), nullptr));
    return values;
  };
  const auto u = table.numbers("u");
  const auto phi = numbers("phi");
  const auto xi = numbers("xi");
  const auto eta = numbers("eta");
  const auto f2 = numbers("f2");
  std::vector<Row> rows;
  for (std::size_t i = 0; i < u.size(); ++i) rows.push_back({u[i], phi[i], xi[i], eta[i], f2[i]});
  REQUIRE(rows.size() > 100);
  return rows;
}

double ulps(double value, long double exact) {
  const double unit = ulp_of(static_cast<double>(exact));
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) /
                             static_cast<long double>(unit));
}

/// |value/exact − 1|, less what a subnormal cannot hold.
double relative(double value, long double exact) {
  const long double error = std::abs(static_cast<long double>(value) - exact);
  if (error <= static_cast<long double>(smallest)) return 0;
  return static_cast<double>(error / std::abs(exact));
}

/// The largest of a kind of error and where it occurred, so that a failure says it.
struct Worst {
  double error = 0;
  double u = 0;
  void see(double e, double at) {
    if (!(e <= error)) {  // a NaN is the worst
      error = e;
      u = at;
    }
  }
};

/// f'' for u <= 1 and u³ f'' above, as in the tables, out of the curvature:
/// at v = u, s = 1 or, so that neither 1/v nor 1/s leaves the normal range,
/// at v = u/2^512, s = 1/2^512, which is the same ratio to the bit.
template <class Law>
double second(const Law& law, double u) {
  if (std::isinf(u)) return law.curvature(1.0, 0.0).ss;
  if (u <= 1) return law.curvature(u, 1.0).vv;
  const double v = u * 0x1p-512;
  return law.curvature(v, 0x1p-512).ss * v;
}

/// Issue: at most 4 units in the last place for Φ, ξ, η. Curvature is for Newton matrices: 1e-14.
template <class Law>
void check_ulps(const Law& law, const std::string& file) {
  Worst phi, xi, eta, f2;
  for (const Row& row : reference(file)) {
    const Reduced r = reduced(law, row.u);
    phi.see(ulps(r.phi, row.phi), row.u);
    xi.see(ulps(r.xi, row.xi), row.u);
    eta.see(ulps(r.eta, row.eta), row.u);
    f2.see(relative(second(law, row.u), row.f2), row.u);
  }
  const auto check = [](const char* what, const Worst& worst, double bound) {
    CAPTURE(what, worst.error, to_text(worst.u));
    CHECK(worst.error <= bound);
  };
  check("phi, ulp", phi, 4);
  check("xi, ulp", xi, 4);
  check("eta, ulp", eta, 4);
  check("f2, relative", f2, 1e-14);
}

}  // namespace

TEST_CASE("UniformLaw against interval arithmetic", "[law][exact][reference]") {
  check_ulps(UniformLaw{}, "laws/uniform.tsv");
  check_ulps(UniformLaw{}, "accuracy/uniform.tsv");
}

TEST_CASE("HertzLaw against interval arithmetic", "[law][exact][reference]") {
  check_ulps(HertzLaw{}, "laws/hertz.tsv");
  check_ulps(HertzLaw{}, "accuracy/hertz.tsv");
}

TEST_CASE("The worst arguments that a random search has found", "[law][exact]") {
  // 2e5 arguments each in [1.32, 1.34], the end of the forms about u = 1, and all others above 3.3 ulp. The
  // values are ₂F₁ of 1/u² in 60 digits.
  struct Found {
    double u;
    long double phi, xi, eta;
  };
  const auto check = [](const Reduced& law, const Found& f) {
    CHECK(ulps(law.phi, f.phi) <= 4);
    CHECK(ulps(law.xi, f.xi) <= 4);
    CHECK(ulps(law.eta, f.eta) <= 4);
  };
  for (const Found& f : {Found{1.3255460278261453, 0.8447718892563364171659968L, 0.9388930257039856542681552L,
                               0.1581499840104312155087441L},
                         {1.3294398396239677, 0.8453906189264410975169305L, 0.9392804724959011112543579L,
                          0.1576356523825836178948132L},
                         {1.3322049008454597, 0.8458281181636986700751785L, 0.9395532779220531762728457L,
                          0.1572725972612432428917176L},
                         {1.3323945773041654, 0.8458580727430075856367757L, 0.9395719214551431682069556L,
                          0.1572477584871140976466564L}}) {
    CAPTURE(to_text(f.u));
    check(reduced(HertzLaw{}, f.u), f);
    Reduced batch{};
    reduced_hertz({&f.u, 1}, {{&batch.phi, 1}, {&batch.xi, 1}, {&batch.eta, 1}});
    check(batch, f);
  }
  for (const Found& f : {Found{1.3307006145351528, 0.8573641267811252230938377L, 0.9232306552514291934206927L,
                               0.1985914946877483905881459L},
                         {1.3332544290969635, 0.8577284464851031165265525L, 0.9235543429127273882031426L,
                          0.1981603504586635795364852L}}) {
    CAPTURE(to_text(f.u));
    check(reduced(UniformLaw{}, f.u), f);
  }
}

TEST_CASE("PowerLaw against interval arithmetic", "[law][exact][reference]") {
  // The file's name carries n as the shortest text of the double.
  for (const char* n : {"-0.99", "-0.9", "-0.5", "-0.25", "0.25", "0.75", "1", "1.5", "2", "3.3", "5", "20",
                        "100", "1000", "1e6"}) {
    const PowerLaw law(std::strtod(n, nullptr));
    Worst phi, xi, eta, f2;
    for (const Row& row : reference("laws/power_" + std::string(n) + ".tsv")) {
      const Reduced r = reduced(law, row.u);
      phi.see(relative(r.phi, row.phi), row.u);
      xi.see(relative(r.xi, row.xi), row.u);
      eta.see(relative(r.eta, row.eta), row.u);
      f2.see(relative(second(law, row.u), row.f2), row.u);
    }
    const auto check = [&](const char* what, const Worst& worst, double bound) {
      CAPTURE(n, what, worst.error, to_text(worst.u));
      CHECK(worst.error <= bound);
    };
    check("phi", phi, 1e-13);
    check("xi", xi, 1e-13);
    check("eta", eta, 1e-13);
    check("f2", f2, 1e-13);
  }
}

TEST_CASE("PowerLaw is the uniform and the Hertz law at n = 0 and n = 1/2", "[law][exact]") {
  const PowerLaw uniform(0);
  const PowerLaw hertz(0.5);
  for (double u = 1e-3; u < 1e3; u *= 1.37) {
    CAPTURE(to_text(u));
    CHECK(uniform.at(u, 1).xi == Approx(UniformLaw{}.at(u, 1).xi).epsilon(1e-13));
    CHECK(uniform.at(u, 1).eta == Approx(UniformLaw{}.at(u, 1).eta).epsilon(1e-13));
    CHECK(hertz.at(u, 1).xi == Approx(HertzLaw{}.at(u, 1).xi).epsilon(1e-13));
    CHECK(hertz.at(u, 1).eta == Approx(HertzLaw{}.at(u, 1).eta).epsilon(1e-13));
  }
}

// -------------------------------------------------------------------------------- edges of the doubles

namespace {

/// An exact law, what is known of it at u = 0, 1, ∞ in closed form, and how accurate it is.
struct Known {
  std::string name;
  std::function<Friction(double, double)> at;
  std::function<Curvature(double, double)> curvature;
  Extent extent;
  double slope;              // f''(0)
  double tail;               // lim u η
  double xi_1, eta_1, f2_1;  // at u = 1
  double accuracy;           // relative
};

template <class Law>
Known known(std::string name, const Law& law, double slope, double tail, double xi_1, double eta_1,
            double f2_1, double accuracy) {
  return {std::move(name),
          [law](double v, double s) { return law.at(v, s); },
          [law](double v, double s) { return law.curvature(v, s); },
          law.extent(),
          slope,
          tail,
          xi_1,
          eta_1,
          f2_1,
          accuracy};
}

const std::vector<Known>& laws() {
  // At u = 1 Gauss's theorem for ₂F₁(·, ·; ·; 1) gives ξ = Γ(n+2)²(n+3/2)/Γ(n+5/2)², η = ξ/(2n+3), f'' =
  // ξ/(2n+2); slope and tail as in PowerLimits, here written out.
  static const std::vector<Known> all{
      known("uniform", UniformLaw{}, 1, 1. / 4, 8 / (3 * pi), 8 / (9 * pi), 4 / (3 * pi), 4 * eps),
      known("hertz", HertzLaw{}, 3 * pi / 8, 1. / 5, 9 * pi / 32, 9 * pi / 128, 3 * pi / 32, 4 * eps),
      known("power:1", PowerLaw(1), 4. / 3, 1. / 6, 128 / (45 * pi), 128 / (225 * pi), 32 / (45 * pi),
            1e-13)};
  return all;
}

}  // namespace

TEST_CASE("Closed forms at u = 1 and one ulp beside it", "[law][exact]") {
  for (const Known& law : laws()) {
    CAPTURE(law.name);
    const double below = 1 - eps / 2;
    const double above = 1 + eps;
    // One ulp beside 1 the law differs by f'' times that, less than an ulp of the values.
    const double near = law.accuracy + eps;
    for (const double v : {below, 1.0, above}) {
      for (const double s : {below, 1.0, above}) {
        CAPTURE(v - 1, s - 1);
        CHECK(law.at(v, s).xi == Approx(law.xi_1).epsilon(near + eps));
        CHECK(law.at(v, s).eta == Approx(law.eta_1).epsilon(near + 4 * eps));
        // f'' has a slope that may grow like a logarithm (uniform), ln(1/ε) = 37: 1e-13 holds 37 · 4 · 2ε.
        CHECK(law.curvature(v, s).vv == Approx(law.f2_1).epsilon(std::max(1e-13, 1e3 * law.accuracy)));
      }
    }
    // The same for a pair of any size.
    for (const double scale : {smallest, 1e-300, 1e300, largest}) {
      CHECK(law.at(scale, scale).xi == law.at(1.0, 1.0).xi);
      CHECK(law.at(scale, scale).eta == law.at(1.0, 1.0).eta);
    }
  }
}

TEST_CASE("Pure drilling, pure sliding and infinity", "[law][exact]") {
  for (const Known& law : laws()) {
    CAPTURE(law.name);
    for (const double x : {smallest, 1e-300, 1.0, 1e300, largest, inf}) {
      CAPTURE(to_text(x));
      CHECK(law.at(0.0, x).xi == 0);
      CHECK(law.at(0.0, x).eta == Approx(law.extent.eta).epsilon(law.accuracy));
      CHECK(law.at(x, 0.0).xi == Approx(1).epsilon(law.accuracy));
      CHECK(law.at(x, 0.0).eta == 0);
    }
    for (const double x : {smallest, 1.0, largest}) {
      CHECK(law.at(inf, x).xi == Approx(1).epsilon(law.accuracy));
      CHECK(law.at(inf, x).eta == 0);
      CHECK(law.at(x, inf).xi == 0);
      CHECK(law.at(x, inf).eta == Approx(law.extent.eta).epsilon(law.accuracy));
    }
    CHECK(law.curvature(0.0, 2.0).vv == Approx(law.slope / 2).epsilon(1e3 * law.accuracy));
    CHECK(law.curvature(0.0, 2.0).vs == 0);
    CHECK(law.curvature(0.0, 2.0).ss == 0);
    CHECK(law.curvature(2.0, 0.0).vv == 0);
    CHECK(law.curvature(2.0, 0.0).vs == 0);
    CHECK(law.curvature(2.0, 0.0).ss == Approx(law.tail / 2).epsilon(1e3 * law.accuracy));
    CHECK(law.curvature(inf, 1.0).ss == 0);
    CHECK(law.curvature(1.0, inf).vv == 0);
  }
}

TEST_CASE("Linear at both ends, down to the last subnormal", "[law][exact]") {
  for (const Known& law : laws()) {
    CAPTURE(law.name);
    // From u = 1e-9 down the next term is below 1e-18.
    for (const double u : {1e-9, 1e-100, 1e-300, 1e-310, 1e-320, smallest}) {
      CAPTURE(to_text(u));
      // Half a quantum of rounding; less than one below the normal range.
      CHECK(std::abs(law.at(u, 1.0).xi - law.slope * u) <= law.accuracy * u * 2 + smallest);
      CHECK(law.at(u, 1.0).eta == Approx(law.extent.eta).epsilon(law.accuracy));
      CHECK(std::abs(law.at(1.0, u).eta - law.tail * u) <= law.accuracy * u * 2 + smallest);
      CHECK(law.at(1.0, u).xi == Approx(1).epsilon(law.accuracy));
    }
    CHECK(law.at(1e300, 1.0).eta == Approx(law.tail * 1e-300).epsilon(law.accuracy));
    CHECK(law.at(1e154, 1e-154).eta == Approx(law.tail * 1e-308).epsilon(1e-13));
  }
}

TEST_CASE("Second derivatives that are normal numbers though u or u² is none", "[law][exact]") {
  for (const Known& law : laws()) {
    CAPTURE(law.name);
    const double accuracy = std::max(1e-15, 1e3 * law.accuracy);
    const auto about = [&](double x) { return Approx(x).epsilon(accuracy).margin(0); };
    // u = 2^-590: u² f''/s = f''(0) 2^-900, and the same outside.
    CHECK(law.curvature(0x1p-870, 0x1p-280).ss == about(law.slope * 0x1p-900));
    CHECK(law.curvature(0x1p-280, 0x1p-870).vv == about(law.tail * 0x1p-900));
    // u = 2^-1040/3: v f''/s² = f''(0) 2^-1010/9.
    CHECK(law.curvature(0x1p-1070, 3 * 0x1p-30).vs == about(-law.slope * 0x1p-1010 / 9));
    CHECK(law.curvature(3 * 0x1p-30, 0x1p-1070).vs == about(-law.tail * 0x1p-1010 / 9));
    // s so small that f''/s overflows, and u s = v does not.
    CHECK(law.curvature(0, smallest).vv == inf);
    CHECK(law.curvature(0, smallest).vs == 0);
    CHECK(law.curvature(0, smallest).ss == 0);
  }
}

TEST_CASE("The law depends on v/s only, to the bit", "[law][exact]") {
  for (const Known& law : laws()) {
    for (const double u : {0x1.8p-20, 0.5, 0.75, 1.25, 3.0, 0x1.4p20}) {
      for (const int k : {-1050, -1000, -3, 7, 1000}) {
        CAPTURE(law.name, u, k);
        const double scale = std::ldexp(1.0, k);
        CHECK(law.at(u * scale, scale).xi == law.at(u, 1.0).xi);
        CHECK(law.at(u * scale, scale).eta == law.at(u, 1.0).eta);
      }
    }
  }
}

TEST_CASE("At rest, NaN and negative speeds there is no number", "[law][exact]") {
  for (const Known& law : laws()) {
    CAPTURE(law.name);
    const std::vector<std::pair<double, double>> bad{
        {0.0, 0.0},       {not_a_number, 1.0}, {1.0, not_a_number}, {not_a_number, 0.0}, {-1.0, 1.0},
        {1.0, -smallest}, {inf, inf},          {-0.0, 0.0},         {not_a_number, inf}};
    for (const auto& [v, s] : bad) {
      CAPTURE(v, s);
      CHECK_THROWS_AS(law.at(v, s), std::domain_error);
      CHECK_THROWS_AS(law.curvature(v, s), std::domain_error);
    }
    CHECK_NOTHROW(law.at(-0.0, 1.0));
  }
}

TEST_CASE("No NaN and nothing outside the ball for any pair of finite speeds", "[law][exact]") {
  std::mt19937_64 random(1963);
  std::uniform_int_distribution<int> exponent(-1074, 1023);
  std::uniform_int_distribution<int> offset(-60, 60);
  std::uniform_real_distribution<double> mantissa(1, 2);
  const auto speed = [&](int k) {
    return std::min(std::ldexp(mantissa(random), std::clamp(k, -1074, 1023)), largest);
  };
  for (const Known& law : laws()) {
    const double slack = 1 + law.accuracy;
    int failures = 0;
    for (int i = 0; i < 100000; ++i) {
      // Half of the pairs anywhere, half of them within 2^±60
      // of each other, where the law is more than its limits.
      const int k = exponent(random);
      const double v = speed(k);
      const double s = speed(i % 2 == 0 ? exponent(random) : k + offset(random));
      const auto [xi, eta] = law.at(v, s);
      const Curvature c = law.curvature(v, s);
      const bool good = xi >= 0 && xi <= slack && eta >= 0 && eta <= law.extent.eta * slack && c.vv >= 0 &&
                        c.vs <= 0 && c.ss >= 0;  // all false for a NaN
      if (!good && ++failures <= 3) {
        CAPTURE(law.name, to_text(v), to_text(s), xi, eta, c.vv, c.vs, c.ss);
        CHECK(good);
      }
    }
    CHECK(failures == 0);
    for (const double x : {smallest, 1e-310, 1e-308, 1.0, largest}) {
      for (const Curvature& c : {law.curvature(0.0, x), law.curvature(x, 0.0), law.curvature(x, x)}) {
        CAPTURE(law.name, to_text(x));
        CHECK_FALSE(std::isnan(c.vv));
        CHECK_FALSE(std::isnan(c.vs));
        CHECK_FALSE(std::isnan(c.ss));
      }
    }
  }
}

TEST_CASE("ξ grows with u and η falls", "[law][exact]") {
  for (const Known& law : laws()) {
    std::vector<double> us;
    for (double u = 1e-8; u < 1e8; u *= 1.003) us.push_back(u);
    for (int i = -2000; i <= 2000; ++i) us.push_back(1 + i * 0x1p-50);
    std::sort(us.begin(), us.end());
    Friction last = law.at(us.front(), 1.0);
    int failures = 0;
    for (const double u : us) {
      const Friction now = law.at(u, 1.0);
      // Both neighbours may err by the accuracy of the law.
      const bool good =
          now.xi >= last.xi * (1 - 2 * law.accuracy) && now.eta <= last.eta * (1 + 2 * law.accuracy);
      if (!good && ++failures <= 3) {
        CAPTURE(law.name, u, now.xi - last.xi, now.eta - last.eta);
        CHECK(good);
      }
      last = now;
    }
    CHECK(failures == 0);
  }
}

TEST_CASE("Reduced form from u = 0 to infinity", "[law][exact]") {
  CHECK(reduced(UniformLaw{}, 0.0).phi == 2.0 / 3);
  CHECK(reduced(UniformLaw{}, inf).phi == 1);
  CHECK(reduced(UniformLaw{}, inf).eta == 0);
  CHECK(reduced(HertzLaw{}, 1e300).phi == 1);
  CHECK(reduced(HertzLaw{}, largest).eta > 0);
  CHECK_THROWS_AS(reduced(UniformLaw{}, not_a_number), std::domain_error);
  CHECK_THROWS_AS(reduced(UniformLaw{}, -1.0), std::domain_error);
}
