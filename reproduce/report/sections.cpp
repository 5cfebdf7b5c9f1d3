#include "sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "accuracy.hpp"
#include "animation.hpp"
#include "captions.hpp"
#include "figures.hpp"
#include "html.hpp"
#include "summaries.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

constexpr std::size_t long_table = 20;      // rows; longer ones are folded
constexpr std::size_t longest_table = 800;  // rows; longer ones stay in data/

const std::string not_there =
    "<p class=\"missing\">Not there yet: the program that writes it has not run.</p>\n";

// A table that an older run or a failed program left with other columns or rows must not keep the page from
// being made.
template <class Words>
std::string if_there(const Words& words) {
  try {
    return words();
  } catch (const std::out_of_range& missing) {
    return fmt::format("<p class=\"missing\">Not as expected: {}.</p>\n", escape(missing.what()));
  }
}

// What the table says.
std::string result(const Table& table, const std::string& name) {
  return if_there([&] {
    const std::string sentence = summary(name, table);
    return sentence.empty() ? "" : fmt::format("<p class=\"result\">{}</p>\n", sentence);
  });
}

// A table of data/ under what it says; empty where it is not there.
std::string told(const fs::path& report, const std::string& name) {
  const fs::path file = report / "data" / (name + ".tsv");
  if (!fs::exists(file)) return "";
  const Table table = contensou::read_table(file);
  if (table.rows.size() > longest_table) {
    return result(table, name) +
           fmt::format("<p class=\"note\">{}: {} rows, in <code>build/report/data/</code>.</p>\n",
                       escape(name + ".tsv"), table.rows.size());
  }
  return result(table, name) + report::table(table, "table-" + name, fmt::format("`{}.tsv`", name),
                                             table.rows.size() <= long_table);
}

// A drawing of figures/ that belongs to tables, not to a figure of the paper; empty where it is not there.
std::string drawn(const fs::path& report, const std::string& name, const std::string& title) {
  const fs::path file = report / "figures" / (name + ".svg");
  if (!fs::exists(file)) return "";
  return if_there([&] {
    const std::string text = caption(name, report / "data");
    return fmt::format("<figure><div class=\"panels\"><div class=\"panel wide\">{}</div></div>{}</figure>\n",
                       inline_svg(file, name, title),
                       text.empty() ? "" : fmt::format("<figcaption><p>{}</p></figcaption>", text));
  });
}

// A drawing, if there is one, and the tables behind it, under a heading.
struct Block {
  std::string heading;
  std::string drawing;
  std::vector<std::string> tables;
};

std::string shown(const fs::path& report, const Block& block) {
  std::string html = block.drawing.empty() ? "" : drawn(report, block.drawing, block.heading);
  for (const std::string& name : block.tables) html += told(report, name);
  if (html.empty()) html = not_there;
  return block.heading.empty() ? html : fmt::format("<h3>{}</h3>\n{}", block.heading, html);
}

std::string shown(const fs::path& report, const std::vector<Block>& blocks) {
  std::string html;
  for (const Block& block : blocks) html += shown(report, block);
  return html;
}

}  // namespace

std::string table_section(const Table& table, const std::string& id, const std::string& title, bool open) {
  return table.rows.empty() ? not_there : result(table, id) + report::table(table, id, title, open);
}

std::string quadrature_section(const fs::path& report) {
  return shown(report,
               Block{"", "", {"verify_quadrature", "verify_quadrature_radial", "verify_quadrature_vectors"}});
}

// The drawing of the errors over u, what to read from it, and the errors by ranges of u.
std::string accuracy_section(const fs::path& report) {
  const fs::path file = report / "data" / "accuracy.tsv";
  std::string html = drawn(report, "accuracy", "Relative errors over u");
  if (fs::exists(file)) {
    const Table table = contensou::read_table(file);
    html += result(table, "accuracy") + if_there([&] { return accuracy_at_a_glance(table); }) +
            report::table(table, "table-accuracy", "`accuracy.tsv`", false);
  }
  return html + shown(report, Block{"", "", {"accuracy_loss", "accuracy_over_u", "accuracy_power"}});
}

std::string plates_section(const fs::path& report) { return shown(report, Block{"", "", {"plates"}}); }

std::string ball_section(const fs::path& report) {
  return shown(report, Block{"", "", {"ball", "ball_iterations"}});
}

std::string contact_section(const fs::path& report) {
  return shown(
      report,
      {{"Does it always end well?", "robustness", {"robustness", "robustness_by_class"}},
       {"Is the solution what the laws say?", "", {"consistency"}},
       {"Where <i>r</i> comes from", "augmented_r", {"augmented_r", "augmented_radius"}},
       {"Somebody else’s solver", "siconos_patch", {"siconos_coulomb", "siconos_patch", "siconos_ball"}}});
}

std::string integrators_section(const fs::path& report) {
  return shown(
      report,
      {{"Orders", "integrator_orders", {"integrator_orders", "integrator_errors"}},
       {"Nutation, rest, energy", "integrator_nutation", {"integrator_habits", "integrator_nutation"}},
       {"The paper’s top by the paper’s schemes", "", {"integrator_paper_top"}}});
}

std::string top_section(const fs::path& report) {
  return animation(report) +
         shown(report,
               {{"When what happens", "", {"fig09_events", "fig12_events"}},
                {"How fast it leaves the upright positions",
                 "stability_growth",
                 {"stability_growth", "fig11_simulated"}},
                {"The story of Section 5.4, and what could make the paper’s times",
                 "story",
                 {"event_story", "story_hypotheses"}},
                {"How fast it inverts", "inversion_over_radius", {"inversion_over_radius", "coulomb_limit"}},
                {"Does it invert?", "phase_map", {"phase_map_spins", "phase_map"}},
                {"Where it ends", "", {"end_states"}}});
}

std::string scenes_section(const fs::path& report) {
  return shown(report, Block{"", "scenes_disc", {"scenes", "scenes_disc_ends"}});
}

std::string cost_section(const fs::path& report) {
  return shown(
      report,
      {{"The law", "cost_laws", {"cost_laws", "cost_laws_front", "cost_ratios"}},
       {"The projection on the friction ball",
        "cost_projection",
        {"cost_projection", "cost_projection_front", "cost_projection_aims"}},
       {"The contact problem", "cost_solvers", {"cost_solvers", "cost_solvers_front", "cost_solver_ratios"}},
       {"The motion of the tippe-top",
        "cost_integrators",
        {"cost_integrators", "cost_integrators_front", "cost_integrators_failures",
         "cost_integrators_aims"}},
       {"Many bodies", "cost_bodies", {"cost_bodies"}}});
}

std::string effects_section(const fs::path& report) {
  return shown(report, {{"What is absent costs nothing", "", {"cost_absent", "effect_costs"}},
                        {"The tippe-top", "audit_tippe_top", {"audit_tippe_top"}},
                        {"A disc that slides and spins to rest", "audit_sliding_disc", {"audit_sliding_disc"}},
                        {"The polishing machine", "audit_polishing_machine", {"audit_polishing_machine"}}});
}

}  // namespace report
