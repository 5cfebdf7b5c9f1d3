// contensou effects: what a scene asks for and therefore what runs.

#include <memory>
#include <optional>
#include <string>

#include "contensou/output/table.hpp"
#include "contensou/scene/effect_table.hpp"
#include "contensou/text/quoted.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "subcommand.hpp"

namespace cli {
namespace {

using contensou::EffectRow;
using contensou::Table;

constexpr const char* description =
    "Effects: what a scene asks for, what therefore runs, and what does not.\n\n"
    "A table of all that a scene could ask for, on standard output; runs nothing.\n"
    "Columns: where    scene, contact.NAME or integrator\n"
    "         effect   such as gravity or drilling friction; of the integrator its settings\n"
    "         runs     yes or no\n"
    "         rows     how many rows of the contact problem it adds to each contact\n"
    "         how      by what it is computed; where it does not run: why not\n";

constexpr const char* examples =
    "Examples:\n"
    "  contensou effects scenes/tippe_top.toml\n"
    "  contensou effects scenes/tippe_top.toml --set contact.body.radius=0\n"
    "  contensou effects scenes/tippe_top.toml --unset contact.tip --set contact.tip.law=frictionless";

/// "gravity, sliding friction (body, tip)": the effects that run, or those that do not, each once.
std::string listed(const std::vector<EffectRow>& rows, bool runs) {
  std::string line;
  for (const EffectRow& row : rows) {
    if (row.runs != runs || row.where == "integrator") continue;
    line += line.empty() ? "" : ", ";
    line += row.effect;
    if (row.where != "scene") line += " (" + row.where.substr(row.where.find('.') + 1) + ')';
  }
  return line.empty() ? "nothing" : line;
}

Table effects_table(const contensou::Scene& scene) {
  const std::vector<EffectRow> rows = effect_rows(scene);
  Table table;
  table.comments = {"contensou effects " + contensou::printable(scene.file) + ", version " CONTENSOU_VERSION,
                    "runs: " + listed(rows, true), "left out: " + listed(rows, false)};
  for (const contensou::ContactScene* contact : scene.contacts())
    table.comments.push_back("rows of " + contact->name + ": " + std::to_string(contact->rows()) + " of 4, " +
                             row_names(*contact));
  table.columns = {"where", "effect", "runs", "rows", "how"};
  for (const EffectRow& row : rows)
    table.add({row.where, row.effect, row.runs ? "yes" : "no", static_cast<double>(row.rows), row.how});
  return table;
}

}  // namespace

void add_effects(CLI::App& program) {
  CLI::App* effects = program.add_subcommand("effects", description);
  const auto command = std::make_shared<Command>();
  add_scene_options(*effects, *command);
  effects->footer(examples);
  effects->callback([command] { deliver(effects_table(changed_scene(*command)), std::nullopt); });
}

}  // namespace cli
