// contensou law: the reduced friction law, phi, xi and eta over u.

#include <unistd.h>

#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bad_input.hpp"
#include "contensou/law/catalogue.hpp"
#include "contensou/output/table.hpp"
#include "numbers.hpp"
#include "options.hpp"
#include "output.hpp"
#include "subcommand.hpp"

namespace cli {
namespace {

constexpr const char* description =
    "The friction law: potential, force and torque of a contact patch that slides and spins.\n\n"
    "A patch of radius R is pressed on with the force lambda_N, slides with the velocity v and spins with "
    "the angular\n"
    "velocity omega. How much of the friction mu lambda_N resists sliding and how much resists spinning "
    "depends on\n"
    "one number only,\n"
    "    u    = |v|/(|omega| R)                  0: spin without sliding ... inf: sliding without spin\n"
    "and for each u given this prints a row u phi xi eta, all without dimension:\n"
    "    phi  = Phi/(mu lambda_N sqrt(v^2 + (omega R)^2))    velocity potential; the power friction takes, "
    "normalised\n"
    "    xi   = |lambda_T|/(mu lambda_N)                     friction force; 1 is the whole of Coulomb's "
    "friction\n"
    "    eta  = |lambda_tau|/(mu lambda_N) = |tau_N|/(mu lambda_N R)     friction torque\n"
    "As u grows xi rises from 0 to 1 and eta falls to 0: spin takes the friction away from sliding. At rest "
    "(v = 0 and\n"
    "omega = 0) friction is the whole set bounded by the curve (xi, eta), and no u stands for it.\n";

constexpr const char* examples =
    "Examples:\n"
    "  contensou law --pressure uniform 0 0.5 1 2 inf\n"
    "  contensou law --pressure hertz --model ellipsoid 1\n"
    "  seq 0 0.01 2 | contensou law --pressure power:1 --out law.tsv\n\n"
    "Input: a u a line where no U is given; blank lines and lines that begin with # are skipped.\n"
    "Output: tab-separated; # comment lines, one line of column names, rows. Numbers are the shortest text "
    "that reads\n"
    "back to the same double. Nothing is written unless every u is good.";

constexpr const char* expected_u = "u = |v|/(|omega| R), a number >= 0 or inf";

struct LawOptions {
  LawChoice law;
  std::vector<std::string> u;
};

double to_slip_ratio(std::string_view text, const std::string& source) {
  const double u = to_number(text, source, expected_u);
  if (u < 0) throw BadInput(source + ": " + in_quotes(text) + " is negative; expected " + expected_u);
  return u;
}

/// The values of u from the command line or else from standard input.
std::vector<double> slip_ratios(const std::vector<std::string>& arguments) {
  std::vector<double> values;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    values.push_back(to_slip_ratio(arguments[i], "argument U number " + std::to_string(i + 1)));
  }
  if (!arguments.empty()) return values;

  if (isatty(STDIN_FILENO) != 0)
    std::cerr << "contensou law: reading u from the keyboard, one a line; Ctrl-D ends\n";
  for_each_data_line(std::cin, "standard input", "one u a line, a number >= 0 or inf",
                     [&](const Line& line) { values.push_back(to_slip_ratio(line.text, line.source)); });
  return values;
}

/// The equations of the paper behind a law.
std::string equations(const LawChoice& options) {
  const double n = contensou::pressure_exponent(options.pressure);
  if (options.model == "printed" && n == 0.5) {
    return "to the letter of LG03 (3.17), (3.18), which lose all digits of eta by u = 1e4, of xi by u = 1e8";
  }
  if (n == 0 && (options.model == "printed" || options.model == "series"))
    return "to the letter of LG03 (2.13), (2.14)";
  if (options.model != "exact") return options.model + ", an approximation, see contensou law --help";
  if (n == 0) return "sigma constant, LG03 (2.1), (2.2), complete elliptic integrals";
  if (n == 0.5) return "sigma ~ sqrt(1 - rho^2/R^2), LG03 (3.14), (3.17), (3.18)";
  return "sigma ~ (1 - rho^2/R^2)^" + contensou::to_text(n) + ", LG03 (2.1) integrated";
}

void run(const LawOptions& options) {
  const contensou::AnyLaw law = chosen(options.law, contensou::make_law);
  const std::vector<double> values = slip_ratios(options.u);

  contensou::Table table;
  table.comments = {made_by("law", options.law), "law: " + equations(options.law),
                    "u = |v|/(|omega| R); phi = Phi/(mu lambda_N sqrt(v^2 + (omega R)^2)), LG03 (2.1)",
                    "xi = |lambda_T|/(mu lambda_N), eta = |lambda_tau|/(mu lambda_N) = |tau_N|/(mu lambda_N "
                    "R), LG03 (3.20)"};
  if (std::holds_alternative<contensou::TanhLaw>(law)) {
    table.comments.emplace_back("this law has a velocity scale: taken at sqrt(v^2 + (omega R)^2) = 1 m/s");
  }
  table.columns = {"u", "phi", "xi", "eta"};
  std::visit(
      [&](const auto& chosen) {
        for (const double u : values) {
          const auto [phi, xi, eta] = contensou::reduced(chosen, u);
          table.add({u, phi, xi, eta});
        }
      },
      law);
  deliver(table, options.law.out);
}

}  // namespace

void add_law(CLI::App& program) {
  CLI::App* law = program.add_subcommand("law", description);

  const auto options = std::make_shared<LawOptions>();
  add_law_choice(*law, options->law);
  law->add_option("U", options->u,
                  "Values of u, each in [0, inf]; where none is given, one\na line from standard input")
      ->option_text("...");
  law->footer(list_of_choices(contensou::model_help()) + examples);
  law->callback([options] { run(*options); });
}

}  // namespace cli
