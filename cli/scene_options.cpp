#include "scene_options.hpp"

#include "bad_input.hpp"

namespace cli {

void add_scene_options(CLI::App& subcommand, Command& command) {
  subcommand.add_option("SCENE", command.scene, "The scene, a TOML file")->required()->option_text(" ");
  subcommand
      .add_option(
          "--set", command.set,
          "Put VALUE, in TOML, in the place of a key of the scene\n(a word needs no quotes); as often "
          "as needed, the last one\ncounts")
      ->allow_extra_args(false)
      ->option_text("KEY=VALUE");
  subcommand
      .add_option("--unset", command.unset, "Remove a key of the scene, or a whole table; before all\n--set")
      ->allow_extra_args(false)
      ->option_text("KEY");
}

contensou::SceneDocument changed_document(const Command& command) {
  try {
    contensou::SceneDocument document = contensou::read_document(command.scene);
    for (const std::string& key : command.unset) contensou::unset_value(document, key);
    for (const std::string& assignment : command.set) contensou::set_value(document, assignment);
    return document;
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
}

contensou::Scene changed_scene(const Command& command) {
  const contensou::SceneDocument changed = changed_document(command);
  try {
    return contensou::read_scene(changed);
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
}

}  // namespace cli
