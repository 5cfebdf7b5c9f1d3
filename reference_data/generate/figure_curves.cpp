// Reference curves of the figures, reference_data/figures/figNN*.tsv: the
// samples of reproduce/figNN, from Gauss's ₂F₁ in interval arithmetic. Shares
// no code with the library or with the figure programs, only their sampling.
//
//   figure_curves FOLDER      writes FOLDER/figNN*.tsv; the same bytes each time

#include <arb.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ball.hpp"
#include "figure_laws.hpp"

namespace {

using namespace reference;

constexpr int digits = 25;

Ball with_sign(const Ball& x, double sign) { return sign < 0 ? exact(0) - x : x; }

/// Rows of numbers with 25 guaranteed digits, under a header that says how they came about.
class Curve {
 public:
  Curve(const std::string& what, const std::string& units, const std::string& columns) {
    text_ = "# " + what + "\n# units: " + units +
            "\n# generator: reference_data/generate/figure_curves.cpp (Arb, Gauss's hypergeometric function)"
            "\n# command: figure_curves reference_data/figures"
            "\n# precision: 25 digits, the last one within 1; arguments exact\n" +
            columns + "\n";
  }
  Curve& number(const Ball& x) {
    if (arb_is_zero(x.raw()) == 0 && !relatively_within(x, 4 * digits)) {
      throw std::runtime_error("a value is not known to enough digits");
    }
    char* const printed = arb_get_str(x.raw(), digits, ARB_STR_NO_RADIUS);
    cell(printed);
    flint_free(printed);
    return *this;
  }
  Curve& word(const std::string& text) {
    cell(text);
    return *this;
  }
  void end_row() {
    text_ += '\n';
    first_ = true;
  }
  void write(const std::filesystem::path& file) const {
    std::ofstream out(file, std::ios::binary);
    out << text_;
    if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
  }

 private:
  void cell(const std::string& text) {
    if (!first_) text_ += '\t';
    text_ += text;
    first_ = false;
  }
  std::string text_;
  bool first_ = true;
};

struct Direction {
  double v;
  double s;
};

// The closed turn on |v| + |s| = 1 in 4n steps, from (0, 1) over (1, 0), (0, -1), (-1, 0).
std::vector<Direction> turn(int n) {
  std::vector<Direction> directions;
  for (int k = 0; k <= 4 * n; ++k) {
    const double t = static_cast<double>(k) / n;  // exact: n is a power of two
    if (t <= 1) {
      directions.push_back({t, 1 - t});
    } else if (t <= 2) {
      directions.push_back({2 - t, 1 - t});
    } else if (t <= 3) {
      directions.push_back({2 - t, t - 3});
    } else {
      directions.push_back({t - 4, t - 3});
    }
  }
  return directions;
}

const Ball uniform = exact(0), hertz = exact(0.5);

void figure_2(const std::filesystem::path& folder) {
  const auto contour = [](Curve& curve, double level, int n) {
    for (const Direction& d : turn(n)) {
      const Ball phi = potential(uniform, std::abs(d.v), std::abs(d.s));
      curve.number(exact(level)).number(level * exact(d.v) / phi).number(level * exact(d.s) / phi).end_row();
    }
  };
  Curve cone("Figure 2a: cone of the velocity potential, uniform pressure", "m/s", "phi\tv\tomega_r");
  for (int ring = 0; ring <= 8; ++ring) contour(cone, ring / 8.0, 16);
  cone.write(folder / "fig02a.tsv");

  Curve contours("Figure 2b: contour lines of the velocity potential, uniform pressure", "m/s",
                 "phi\tv\tomega_r");
  for (const double level : {0.25, 0.5, 0.75, 1.0}) contour(contours, level, 32);
  contours.write(folder / "fig02b.tsv");
}

struct Force {
  double t;
  double tau;
  bool inside;
};

// As in reproduce/fig03/fig03.cpp.
const std::vector<Force> forces{{0, 0.875, false},      {0.125, 0.8125, false}, {0.25, 1, false},
                                {0.375, 0.75, false},   {0.5, 0.875, false},    {0.6875, 0.9375, false},
                                {0.75, 0.625, false},   {1, 0.875, false},      {0.9375, 0.4375, false},
                                {1.125, 0.6875, false}, {1.25, 0.5, false},     {1.0625, 0.25, false},
                                {1.25, 0.25, false},    {1.125, 0.0625, false}, {1.25, 0, false},
                                {0.5, 0.25, true},      {0.25, 0.5, true}};

void figure_3(const std::filesystem::path& folder) {
  Curve disk("Figure 3a: border of the friction disk", "forces in μλ_N", "lambda_t1\tlambda_t2");
  for (const Direction& d : turn(32)) {
    const Ball length = sqrt(exact(d.v) * exact(d.v) + exact(d.s) * exact(d.s));
    disk.number(exact(d.v) / length).number(exact(d.s) / length).end_row();
  }
  disk.write(folder / "fig03a.tsv");

  Curve plate("Figure 3b: border of the friction plate, uniform pressure", "forces in μλ_N",
              "lambda_t\tlambda_tau");
  for (const Direction& d : turn(64)) {
    const Pair f = law(uniform, std::abs(d.v), std::abs(d.s));
    plate.number(with_sign(f.xi, d.v)).number(with_sign(f.eta, d.s)).end_row();
  }
  plate.write(folder / "fig03b.tsv");

  Curve printed("Figure 3b: border of the friction plate as LG03 (2.18) prints it", "forces in μλ_N",
                "branch\tlambda_t\tlambda_tau");
  for (const Printed& p : printed_border()) printed.word(p.branch).number(p.at.xi).number(p.at.eta).end_row();
  printed.write(folder / "fig03b_printed.tsv");

  Curve projections("Figure 3c: forces and the nearest points of the friction plate, uniform pressure",
                    "forces in μλ_N", "lambda_t\tlambda_tau\tnearest_t\tnearest_tau\tinside");
  for (const Force& f : forces) {
    const Pair x = f.inside ? Pair{exact(f.t), exact(f.tau)} : nearest(uniform, f.t, f.tau);
    projections.number(exact(f.t))
        .number(exact(f.tau))
        .number(x.xi)
        .number(x.eta)
        .word(f.inside ? "1" : "0")
        .end_row();
  }
  projections.write(folder / "fig03c.tsv");
}

// cos and sin of the azimuth of a meridian; exact at the quarter turns, where one of the two vanishes.
struct Azimuth {
  explicit Azimuth(int meridian) : cosine(bits), sine(bits) {
    const Ball angle = exact(meridian) / 24.0;  // in units of π
    arb_sin_cos_pi(sine.raw(), cosine.raw(), angle.raw(), bits);
  }
  Ball cosine;
  Ball sine;
};

void figure_4(const std::filesystem::path& folder) {
  const std::string columns = "meridian\tlambda_t1\tlambda_t2\tlambda_tau";
  const auto add = [](Curve& curve, int meridian, const Azimuth& azimuth, const Ball& t, const Ball& tau) {
    curve.number(exact(meridian)).number(t * azimuth.cosine).number(t * azimuth.sine).number(tau).end_row();
  };
  Curve ball("Figure 4: friction ball, uniform pressure", "forces in μλ_N", columns);
  for (int m = 0; m <= 48; ++m) {
    const Azimuth azimuth(m);
    for (const Direction& d : turn(16)) {
      if (d.v < 0) break;
      const Pair f = law(uniform, d.v, std::abs(d.s));
      add(ball, m, azimuth, f.xi, with_sign(f.eta, d.s));
    }
  }
  ball.write(folder / "fig04.tsv");

  Curve printed("Figure 4: meridians of the friction ball as LG03 (2.19) prints it", "forces in μλ_N",
                columns);
  const std::vector<Printed> border = printed_border();
  for (int m = 30; m <= 48; m += 6) {
    const Azimuth azimuth(m);
    for (const Printed& p : border) add(printed, m, azimuth, p.at.xi, p.at.eta);
  }
  printed.write(folder / "fig04_printed.tsv");
}

void figure_5(const std::filesystem::path& folder) {
  Curve force("Figure 5a: friction force over u", "dimensionless", "u\txi_uniform\txi_hertz");
  Curve torque("Figure 5b: friction torque over 1/u", "dimensionless", "inverse_u\teta_uniform\teta_hertz");
  for (int k = 0; k <= 256; ++k) {
    const double x = k / 64.0;
    force.number(exact(x)).number(law(uniform, x, 1).xi).number(law(hertz, x, 1).xi).end_row();
    torque.number(exact(x)).number(law(uniform, 1, x).eta).number(law(hertz, 1, x).eta).end_row();
  }
  force.write(folder / "fig05a.tsv");
  torque.write(folder / "fig05b.tsv");
}

void figure_6(const std::filesystem::path& folder) {
  Curve force("Figure 6a: friction force over v for fixed γ_τ", "m/s; forces in μλ_N",
              "v\t0.125\t0.25\t0.5\t1");
  Curve torque("Figure 6b: friction torque over γ_τ for fixed v", "m/s; forces in μλ_N",
               "gamma_tau\t0.125\t0.25\t0.5\t1");
  for (int k = -128; k <= 128; ++k) {
    const double x = k / 64.0;
    force.number(exact(x));
    torque.number(exact(x));
    for (const double fixed : {0.125, 0.25, 0.5, 1.0}) {
      force.number(with_sign(law(uniform, std::abs(x), fixed).xi, x));
      torque.number(with_sign(law(uniform, fixed, std::abs(x)).eta, x));
    }
    force.end_row();
    torque.end_row();
  }
  force.write(folder / "fig06a.tsv");
  torque.write(folder / "fig06b.tsv");

  // At rest the set is [−max, max]: the extreme values of the
  // friction ball, reached without spin and without sliding.
  const auto set = [&](const char* file, const std::string& columns, const Ball& most) {
    Curve graph("Figure 6: set-valued limit", "m/s; force in μλ_N", columns);
    graph.number(exact(-2)).number(with_sign(most, -1)).end_row();
    graph.number(exact(0)).number(with_sign(most, -1)).end_row();
    graph.number(exact(0)).number(most).end_row();
    graph.number(exact(2)).number(most).end_row();
    graph.write(folder / file);
  };
  set("fig06a_set.tsv", "v\tminus_lambda_t", law(uniform, 1, 0).xi);
  set("fig06b_set.tsv", "gamma_tau\tminus_lambda_tau", law(uniform, 0, 1).eta);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: figure_curves FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    figure_2(folder);
    figure_3(folder);
    figure_4(folder);
    figure_5(folder);
    figure_6(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figure_curves: %s\n", error.what());
    return 1;
  }
  flint_cleanup();
  return 0;
}
