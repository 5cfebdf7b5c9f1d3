#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "bad_input.hpp"
#include "subcommand.hpp"

namespace cli {

/// What every subcommand that works with one law is asked: which, and where the table goes.
struct LawChoice {
  std::string pressure;
  std::string model = "exact";
  std::optional<std::string> out;
};

/// Adds --pressure, --model and --out.
void add_law_choice(CLI::App& subcommand, LawChoice& choice);

/// The part of the help that lists the pressures and the models, one a line.
std::string list_of_choices(const std::string& models);

/// Throws BadInput where there is no such pressure.
void require_pressure(const LawChoice& choice);
/// "--model: ...", with model and pressure named, whatever layer the error comes from.
BadInput blame_model(const LawChoice& choice, const std::invalid_argument& error);

/// make(pressure, model); where there is none, BadInput says which of the two options is to blame.
template <class Make>
auto chosen(const LawChoice& choice, const Make& make) {
  require_pressure(choice);
  try {
    return make(choice.pressure, choice.model);
  } catch (const std::invalid_argument& error) {
    throw blame_model(choice, error);
  }
}

/// The first comment of a table: the command that made it, and by which version of the program.
std::string made_by(const std::string& subcommand, const LawChoice& choice);

}  // namespace cli
