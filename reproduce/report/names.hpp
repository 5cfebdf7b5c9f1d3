#pragma once

#include <string>
#include <string_view>

/// The words of the tables as the page says them; what is not known stays as it is.
namespace report {

/// "phi" as Φ.
std::string quantity_name(std::string_view quantity);
/// "hertz" as Hertz.
std::string pressure_name(std::string_view pressure);
/// "textbook_ke_gsl" as K, E (GSL).
std::string method_name(std::string_view method);

}  // namespace report
