#pragma once

#include <CLI/CLI.hpp>

namespace cli {

// Each adds one subcommand; its work is done, and BadInput thrown, by the subcommand's callback.
void add_law(CLI::App& program);
void add_project(CLI::App& program);
void add_simulate(CLI::App& program);
void add_effects(CLI::App& program);
void add_sweep(CLI::App& program);

}  // namespace cli
