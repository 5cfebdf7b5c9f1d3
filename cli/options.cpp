#include "options.hpp"

#include <sstream>

#include "contensou/law/catalogue.hpp"

namespace cli {
namespace {

std::string indented(const std::string& lines) {
  std::string text;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) text += "  " + line + '\n';
  return text;
}

}  // namespace

void add_law_choice(CLI::App& subcommand, LawChoice& choice) {
  subcommand
      .add_option("--pressure", choice.pressure,
                  "How the pressure sigma falls off towards the rim: one of\nthose below")
      ->required()
      ->option_text("P");
  subcommand.add_option("--model", choice.model, "exact (if not given), or one of those below")
      ->option_text("M");
  subcommand.add_option("--out", choice.out, "Write to FILE, all or nothing, instead of to standard\noutput")
      ->option_text("FILE");
}

std::string list_of_choices(const std::string& models) {
  return "Pressures:\n" + indented(contensou::pressure_help()) + "\nModels:\n" + indented(models) + '\n';
}

void require_pressure(const LawChoice& choice) {
  try {
    contensou::pressure_exponent(choice.pressure);
  } catch (const std::invalid_argument& error) {
    throw BadInput(std::string("--pressure: ") + error.what());
  }
}

BadInput blame_model(const LawChoice& choice, const std::invalid_argument& error) {
  const std::string what = error.what();
  const bool named =
      what.find(choice.model) != std::string::npos || what.find(choice.pressure) != std::string::npos;
  return BadInput("--model: " + (named ? what : choice.model + " for " + choice.pressure + ": " + what));
}

std::string made_by(const std::string& subcommand, const LawChoice& choice) {
  return "contensou " + subcommand + " --pressure " + choice.pressure + " --model " + choice.model +
         ", version " CONTENSOU_VERSION;
}

}  // namespace cli
