// contensou effects: what a scene asks for and therefore what runs, and what each effect is worth.

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "audit_picture.hpp"
#include "audit_table.hpp"
#include "bad_input.hpp"

#include "contensou/output/table.hpp"
#include "contensou/scene/effect_table.hpp"
#include "contensou/text/quoted.hpp"
#include "output.hpp"
#include "output_folder.hpp"
#include "scene_options.hpp"
#include "subcommand.hpp"

namespace cli {
namespace {

using contensou::EffectRow;
using contensou::Table;

constexpr const char* description =
    "Effects: what a scene asks for, what therefore runs, and what each effect is worth.\n\n"
    "A table of all that a scene could ask for, on standard output:\n"
    "Columns: where    scene, contact.NAME or integrator\n"
    "         effect   such as gravity or drilling friction; of the integrator its settings\n"
    "         runs     yes or no\n"
    "         rows     how many rows of the contact problem it adds to each contact\n"
    "         how      by what it is computed; where it does not run: why not\n\n"
    "With --audit it runs the scene with each effect off or simplified in turn, and tabulates for each "
    "variant "
    "the\n"
    "change of each outcome, [outcome.NAME], and the time of a run: on standard output, or with --out as\n"
    "audit.tsv and as a picture, audit.svg.\n";

constexpr const char* examples =
    "Examples:\n"
    "  contensou effects scenes/tippe_top.toml\n"
    "  contensou effects scenes/tippe_top.toml --unset contact.tip --set contact.tip.law=frictionless\n"
    "  contensou effects scenes/tippe_top.toml --set scene.duration=2 --audit --repeat 1 --out worth\n\n"
    "Variants: of contacts (all at once, and each alone) friction exact, ellipsoid, uncoupled, coulomb, "
    "frictionless;\n"
    "pressure hertz, uniform; a radius that follows the load made constant; restitution off. Gravity, drag, "
    "loads and\n"
    "fidelity off; tolerance times 100, step times 2 and 10; another method. One that cannot be run is a row "
    "with its\n"
    "status. Where the scene names no outcome, the last values of all columns are compared.";

struct EffectsOptions {
  Command command;
  bool audit = false;
  std::optional<std::string> out;
  bool quiet = false;
  int repeat = 3;
};

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

/// Which run is being made, on one line of a terminal, written over again and again.
class AuditProgress {
 public:
  explicit AuditProgress(bool shown) : shown_(shown) {}
  ~AuditProgress() {
    if (shown_) std::cerr << erase << std::flush;
  }
  AuditProgress(const AuditProgress&) = delete;
  AuditProgress& operator=(const AuditProgress&) = delete;

  void show(std::size_t done, std::size_t all, const contensou::Variation& next) const {
    if (!shown_) return;
    std::cerr << erase << "run " << done + 1 << " of " << all << ": "
              << contensou::shortened(next.effect + ' ' + next.variant) << std::flush;
  }

 private:
  static constexpr const char* erase = "\r\x1b[K";
  bool shown_;
};

contensou::Audit audit_with_progress(const contensou::SceneDocument& document, const std::string& file,
                                     const EffectsOptions& options) {
  const AuditProgress progress(!options.quiet && isatty(STDERR_FILENO) != 0);
  try {
    return contensou::audit(
        document, {.repeat = options.repeat,
                   .progress = [&](std::size_t done, std::size_t all, const contensou::Variation& next) {
                     progress.show(done, all, next);
                   }});
  } catch (const contensou::SceneError& error) {
    throw BadInput(error.what());
  } catch (const std::invalid_argument& error) {
    throw BadInput(file + ": " + contensou::printable(error.what()));
  }
}

void run_audit(const EffectsOptions& options) {
  const contensou::SceneDocument document = changed_document(options.command);
  const contensou::Scene scene = changed_scene(options.command);
  if (options.out) require_writable(*options.out);
  const contensou::Audit audit = audit_with_progress(document, scene.file, options);
  const std::string table = contensou::to_text(audit_table(audit, scene, options.repeat));
  if (!options.out) return deliver(table, std::nullopt);
  const std::filesystem::path folder = *options.out;
  const std::string picture = audit_picture(audit, scene);
  write_together({{folder / "audit.tsv", table}, {folder / "audit.svg", picture}});
  if (!options.quiet)
    deliver(std::to_string(audit.rows.size()) + " variants: audit.tsv, audit.svg in " +
                contensou::printable(folder.string()) + '\n',
            std::nullopt);
}

void run(const EffectsOptions& options) {
  if (options.audit) return run_audit(options);
  if (options.out) throw BadInput("--out: is not used without --audit; expected --audit");
  deliver(effects_table(changed_scene(options.command)), std::nullopt);
}

}  // namespace

void add_effects(CLI::App& program) {
  CLI::App* effects = program.add_subcommand("effects", description);
  const auto options = std::make_shared<EffectsOptions>();
  add_scene_options(*effects, options->command);
  effects->add_flag("--audit", options->audit, "Run the scene with each effect off or simplified");
  effects
      ->add_option(
          "--out", options->out,
          "The folder to write audit.tsv and audit.svg into, instead\nof the table to standard output")
      ->option_text("DIR");
  effects->add_option("--repeat", options->repeat, "Runs of each variant, for its time (3 if not given)")
      ->check(CLI::Range(1, 1000))
      ->option_text("N");
  effects->add_flag("--quiet", options->quiet, "No progress, no closing line");
  effects->footer(examples);
  effects->callback([options] { run(*options); });
}

}  // namespace cli
