// contensou project: the nearest point of the friction ball to each force, LG03 (4.12).

#include <unistd.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "bad_input.hpp"
#include "contensou/ball/catalogue.hpp"
#include "contensou/output/table.hpp"
#include "numbers.hpp"
#include "options.hpp"
#include "output.hpp"
#include "subcommand.hpp"

namespace cli {
namespace {

constexpr const char* description =
    "The friction ball: the nearest admissible force to each force given.\n\n"
    "The friction force lambda_T = (lambda_T1, lambda_T2) and the friction torque tau_N = lambda_tau R that "
    "a "
    "contact\n"
    "patch of radius R can bear under the normal force lambda_N form a convex set, the friction ball. Where "
    "a "
    "force is\n"
    "in it the patch can stick; else friction gives the nearest point, and the patch slips along the "
    "difference.\n"
    "Every simulator's step is built on this projection. Each line of standard input is a force\n"
    "    l1 l2 ltau                              (lambda_T1, lambda_T2, lambda_tau)/(mu lambda_N)\n"
    "and for each this prints a row p1 p2 ptau inside iterations residual:\n"
    "    p1 p2 ptau    the nearest point of the ball, in the same units; inside it the force itself\n"
    "    inside        1 where the force is in the ball, 0 where it is not\n"
    "    iterations    how many points of the border were looked at; 0 where none had to be\n"
    "    residual      proof of the result: the part of l - p across the normal of the ball at p, in the "
    "same "
    "units;\n"
    "                  0 inside, elsewhere rounding, about 1e-16 of the largest of l and 1\n";

constexpr const char* examples =
    "Examples:\n"
    "  echo 1 0.5 1 | contensou project --pressure uniform\n"
    "  printf '0.5 0 0.2\\n3 4 0\\n' | contensou project --pressure hertz --model ellipsoid\n"
    "  seq -f '1 0 %g' 0 0.1 2 | contensou project --pressure power:1 --out points.tsv\n\n"
    "Input: three finite numbers a line, between blanks; blank lines and lines that begin with # are "
    "skipped.\n"
    "Output: tab-separated; # comment lines, one line of column names, rows. Numbers are the shortest text "
    "that reads\n"
    "back to the same double. Nothing is written unless every line is good.";

constexpr const char* expected_line = "l1 l2 ltau a line, three finite numbers";
constexpr std::array<const char*, 3> components{"l1", "l2", "ltau"};

using contensou::FrictionForce;

FrictionForce to_force(const Line& line) {
  const std::vector<std::string_view> numbers = words(line.text);
  if (numbers.size() != components.size()) {
    throw BadInput(line.source + ": " + in_quotes(line.text) + " holds " + std::to_string(numbers.size()) +
                   (numbers.size() == 1 ? " value" : " values") + "; expected " + expected_line);
  }
  FrictionForce force;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::string source = line.source + ": " + components[i];
    const double x = to_number(numbers[i], source, "a finite number");
    if (std::isinf(x))
      throw BadInput(source + ": " + in_quotes(numbers[i]) + " is not finite; expected a finite number");
    force[static_cast<Eigen::Index>(i)] = x;
  }
  return force;
}

std::vector<FrictionForce> forces() {
  if (isatty(STDIN_FILENO) != 0)
    std::cerr << "contensou project: reading l1 l2 ltau from the keyboard, a force a line; Ctrl-D ends\n";
  std::vector<FrictionForce> values;
  for_each_data_line(std::cin, "standard input", expected_line,
                     [&](const Line& line) { values.push_back(to_force(line)); });
  return values;
}

template <class Ball>
void append_row(std::string& text, const Ball& ball, const FrictionForce& force) {
  constexpr double size = 1;  // μλ_N, the unit
  const auto q = ball.project(force, size);
  for (const double x : {q.point[0], q.point[1], q.point[2]}) text += contensou::to_text(x) + '\t';
  text += q.inside ? "1\t" : "0\t";
  text += std::to_string(q.iterations) + '\t' + contensou::to_text(q.residual) + '\n';
}

void run(const LawChoice& choice) {
  const contensou::AnyBall ball = chosen(choice, contensou::make_ball);

  const contensou::Table head{
      {made_by("project", choice),
       "p1 p2 ptau: the nearest point to (lambda_T1, lambda_T2, lambda_tau) of the friction ball, LG03 "
       "(2.19), (4.12),",
       "  in units of mu lambda_N, lambda_tau = tau_N/R; inside: 1 where the force is in the ball, else 0",
       "iterations: points of the border evaluated; residual: the part of l - p across the normal, in units "
       "of mu lambda_N"},
      {"p1", "p2", "ptau", "inside", "iterations", "residual"},
      {}};
  std::string text = to_text(head);
  std::visit(
      [&, values = forces()](const auto& chosen_ball) {
        for (const FrictionForce& force : values) append_row(text, chosen_ball, force);
      },
      ball);
  deliver(text, choice.out);
}

}  // namespace

void add_project(CLI::App& program) {
  CLI::App* project = program.add_subcommand("project", description);

  const auto choice = std::make_shared<LawChoice>();
  add_law_choice(*project, *choice);
  project->footer(list_of_choices(contensou::ball_model_help()) + examples);
  project->callback([choice] { run(*choice); });
}

}  // namespace cli
