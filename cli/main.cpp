// The contensou program: parses the command line, leaves the work to the subcommands, and turns every error
// into one line on standard error and an exit status.

#include <iostream>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "bad_input.hpp"
#include "numbers.hpp"
#include "subcommand.hpp"
#include "sweep_crew.hpp"

namespace {

using cli::in_quotes;

/// What the program was asked to be when the error happened: "contensou" or "contensou law".
std::string full_name(const CLI::App& program) {
  std::string name = program.get_name();
  for (const CLI::App* subcommand : program.get_subcommands()) name += ' ' + subcommand->get_name();
  return name;
}

std::string on_one_line(std::string text) {
  for (char& character : text) {
    if (character == '\n' || character == '\r') character = ' ';
  }
  return text;
}

/// What is wrong with an argument that nothing on the command line takes.
std::string explain_stray(const CLI::App& program, const std::string& stray, const std::string& help) {
  const auto subcommands = program.get_subcommands();
  if (cli::is_number(stray) && !subcommands.empty()) {
    if (subcommands.front()->get_option_no_throw("U") == nullptr)
      return "argument " + in_quotes(stray) + " was not expected" + help;
    return "argument " + in_quotes(stray) + " is negative or NaN; expected a number >= 0 or inf";
  }
  if (stray.starts_with('-')) return in_quotes(stray) + " is not an option" + help;
  if (!subcommands.empty()) return in_quotes(stray) + " was not expected" + help;
  std::string names;
  for (const CLI::App* subcommand : program.get_subcommands({})) names += ' ' + subcommand->get_name();
  return in_quotes(stray) + " is not a subcommand; expected one of:" + names;
}

/// CLI11's error in the words of this program: the value, and what was expected.
std::string explain(const CLI::App& program, const CLI::ParseError& error) {
  const std::string help = "; see " + full_name(program) + " --help";
  const std::vector<std::string> strays = program.remaining(true);
  if (!strays.empty()) return explain_stray(program, strays.front(), help);

  const std::string what = on_one_line(error.what());
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    return what.substr(0, what.find(':')) + ": expected exactly one value" + help;
  }
  return what + help;
}

/// CLI11 would quietly take "[1,2]" for the two values 1 and 2; here a value is what it says.
void refuse_lists(int argc, char** argv) {
  for (const std::string_view argument :
       std::span(argv, static_cast<std::size_t>(argc)).subspan(argc > 0 ? 1 : 0)) {
    if (argument.starts_with('[') && argument.ends_with(']')) {
      throw cli::BadInput("argument " + in_quotes(argument) +
                          " is a list in brackets; expected single values");
    }
  }
}

/// Lists each subcommand by the first line of its description.
class Formatter : public CLI::Formatter {
 public:
  Formatter() { column_width(26); }

  std::string make_subcommand(const CLI::App* subcommand) const override {
    const std::string description = subcommand->get_description();
    std::ostringstream line;
    CLI::detail::format_help(line, subcommand->get_name(), description.substr(0, description.find('\n')),
                             get_column_width());
    return line.str();
  }
};

int run(int argc, char** argv) {
  CLI::App program(
      "Coulomb-Contensou friction: how sliding and spinning share the friction of a contact patch.",
      "contensou");
  program.set_version_flag("--version", "contensou " CONTENSOU_VERSION, "Print the version and exit");
  program.formatter(std::make_shared<Formatter>());
  program.footer(
      "The laws are those of R.I. Leine, Ch. Glocker, A set-valued force law for spatial Coulomb-Contensou "
      "friction,\n"
      "European Journal of Mechanics A/Solids 22 (2003) 193-216; LG03 (2.1) is its equation (2.1).\n\n"
      "Exit status: 0 done; 1 the result could not be written, or a simulation did not reach its end; 2 bad "
      "input.\n"
      "An error is one line on standard error, and then nothing is written to standard output.");
  cli::add_law(program);
  cli::add_project(program);
  cli::add_simulate(program);
  cli::add_effects(program);
  cli::add_sweep(program);

  const auto complain = [&](const std::string& message, cli::Status status) {
    // Of the processes of one sweep the first speaks for all, and mpirun ends the others when one has failed.
    if (full_name(program) == "contensou sweep" && !cli::mpi_job().first) return cli::done;
    std::cerr << full_name(program) << ": " << message << '\n';
    return status;
  };
  try {
    refuse_lists(argc, argv);
    program.parse(argc, argv);
    if (program.get_subcommands().empty()) {
      std::cerr << program.help();
      return cli::bad_input;
    }
  } catch (const CLI::Success& request) {  // --help or --version
    program.exit(request, std::cout, std::cerr);
    std::cout.flush();
    return std::cout ? cli::done : complain("standard output: cannot be written", cli::failed);
  } catch (const CLI::ParseError& error) {
    return complain(explain(program, error), cli::bad_input);
  } catch (const cli::BadInput& error) {
    return complain(error.what(), cli::bad_input);
  } catch (const cli::Interrupted& stopped) {
    constexpr int by_signal = 128;  // as shells count
    complain(stopped.what(), cli::failed);
    return by_signal + stopped.signal;
  } catch (const std::exception& error) {
    return complain(on_one_line(error.what()), cli::failed);
  }
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);  // standard input can be a million lines
  return run(argc, argv);
}
