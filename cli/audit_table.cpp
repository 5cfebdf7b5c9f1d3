#include "audit_table.hpp"

#include <cmath>

#include "contensou/text/quoted.hpp"

namespace cli {

using contensou::Audit;
using contensou::AuditRow;
using contensou::MeasureScene;
using contensou::OutcomeChange;
using contensou::Table;
using contensou::Variation;

double relative_change(const OutcomeChange& change) {
  return change.change == 0 ? 0 : change.change / std::abs(change.reference);
}

Table audit_table(const Audit& audit, const contensou::Scene& scene, int repeat) {
  Table table;
  table.comments = {
      "contensou effects --audit " + contensou::printable(scene.file) + ", version " CONTENSOU_VERSION,
      "what each effect of the scene is worth: the change of its outcomes where it is off or simplified, and "
      "its time",
      "seconds: of one run, the shortest of " + std::to_string(repeat) +
          ", the variants taking turns; time_ratio: to what it is compared with",
      "value, reference: the outcome of this variant, of what it is compared with; change: how far they are "
      "apart (for a",
      "trajectory the root mean square over time of the difference); relative: to the reference; nan: there "
      "is "
      "none",
      "compared_with: another variant; \"scene\" is the scene as it is, by method " +
          std::string(name(scene.integrator.method))};
  if (!audit.named)
    table.comments.emplace_back("the scene names no [outcome.NAME]: last values of all columns");
  table.columns = {"effect",     "variant",   "contacts",      "outcome",  "kind",
                   "value",      "reference", "change",        "relative", "seconds",
                   "time_ratio", "steps",     "compared_with", "status",   "options"};
  for (std::size_t i = 0; i < audit.rows.size(); ++i) {
    const Variation& variation = audit.variations[i];
    const Variation& other = audit.variations[variation.against];
    const AuditRow& row = audit.rows[i];
    std::string options;
    for (const std::string& option : variation.options) options += (options.empty() ? "" : " ") + option;
    for (std::size_t k = 0; k < audit.measures.size(); ++k) {
      const MeasureScene& measure = audit.measures[k];
      const OutcomeChange& change = row.outcomes[k];
      table.add({variation.effect, variation.variant, variation.contacts.empty() ? "-" : variation.contacts,
                 measure.name, name(measure.kind), change.value, change.reference, change.change,
                 relative_change(change), row.seconds, row.time_ratio, static_cast<double>(row.steps),
                 variation.against == 0 ? "scene" : other.effect + ' ' + other.variant,
                 contensou::printable(row.status), contensou::printable(options.empty() ? "-" : options)});
    }
  }
  return table;
}

}  // namespace cli
