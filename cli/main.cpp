// The contensou program: parses the command line, leaves the work to the subcommands, and turns every error
// into one line on standard error and an exit status.

#include <iostream>
#include <string>

#include "numbers.hpp"
#include "subcommand.hpp"

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

/// CLI11's error in the words of this program: the value, and what was expected.
std::string explain(const CLI::App& program, const CLI::ParseError& error) {
  const std::string help = "; see " + full_name(program) + " --help";
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::string stray = program.remaining(true).front();
    if (stray.starts_with('-')) return in_quotes(stray) + " is not an option" + help;
    if (!program.get_subcommands().empty()) return in_quotes(stray) + " was not expected" + help;
    std::string names;
    for (const CLI::App* subcommand : program.get_subcommands({})) names += ' ' + subcommand->get_name();
    return in_quotes(stray) + " is not a subcommand; expected one of:" + names;
  }
  return on_one_line(error.what()) + help;
}

int run(int argc, char** argv) {
  CLI::App program(
      "Coulomb-Contensou friction: how sliding and spinning share the friction of a contact patch.",
      "contensou");
  program.set_version_flag("--version", "contensou " CONTENSOU_VERSION, "Print the version and exit");
  program.get_formatter()->column_width(26);
  program.footer(
      "The laws are those of R.I. Leine, Ch. Glocker, A set-valued force law for spatial Coulomb-Contensou "
      "friction,\n"
      "European Journal of Mechanics A/Solids 22 (2003) 193-216; LG03 (2.1) is its equation (2.1).\n\n"
      "Exit status: 0 done; 1 the result could not be written to standard output; 2 bad input. An error is "
      "one line\n"
      "on standard error, and then nothing is written to standard output.");
  cli::add_law(program);

  const auto complain = [&](const std::string& message, cli::Status status) {
    std::cerr << full_name(program) << ": " << message << '\n';
    return status;
  };
  try {
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
  } catch (const std::exception& error) {
    return complain(on_one_line(error.what()), cli::failed);
  }
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) { return run(argc, argv); }
