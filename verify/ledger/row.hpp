#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The paper ledger: every numbered equation and every quantitative sentence of Sections 2 to 5 and
/// Appendix A of LG03, each put to the test. A row computes what is printed and, where that fails, what
/// should stand there; the verdict follows.
namespace verify::ledger {

/// One reading of a statement against an independent value.
struct Trial {
  double expected = 0;
  double obtained = 0;
  double error = 0;
};

/// What a row's program found.
struct Finding {
  Trial printed;
  std::optional<Trial> corrected;  ///< where something is to be corrected
  double bound;                    ///< for both; fixed from analysis, the reason beside it
  std::string evidence;
};

/// What a statement is called if its printed form exceeds the bound and its corrected form does not.
enum class Flaw {
  none,           ///< it is thought to hold; failing is a failure of the run
  misprint,       ///< a slip of the pen: the text around it uses the right form
  wrong,          ///< says something that is not so
  imprecise,      ///< right under a condition, or in a sense, that is not stated
  not_checkable,  ///< no number decides it; the reason stands in the evidence
};

struct Row {
  std::string id;     ///< of its claims: ledger.ID.printed, ledger.ID.corrected
  std::string where;  ///< an equation number, or a sentence and its place
  std::string printed;
  Flaw flaw = Flaw::none;
  std::string corrected = {};
  std::string consequence = {};
  std::function<Finding()> check = {};
  std::string reason = {};  ///< why it is not checkable
};

std::vector<Row> section2();
std::vector<Row> section3();
std::vector<Row> friction_ball();         ///< the sets of Sections 2 and 3
std::vector<Row> section4();              ///< 4.1
std::vector<Row> augmented_lagrangian();  ///< of it (4.10) to (4.17)
std::vector<Row> section4_2();
std::vector<Row> section5_system();     ///< 5.1 to 5.3
std::vector<Row> section5_data();       ///< the data of 5.4
std::vector<Row> section5_stability();  ///< 5.5
std::vector<Row> appendix_a();
std::vector<Row> sentences();

}  // namespace verify::ledger
