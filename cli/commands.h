// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

// One function a command, each in commands/NAME.cpp: declares its options and what it runs.

void add_summary_command(CLI::App& app);
void add_signatures_command(CLI::App& app);
void add_shape_command(CLI::App& app);
void add_locate_command(CLI::App& app);
void add_persistence_command(CLI::App& app);
void add_alpha_command(CLI::App& app);
void add_enforce_command(CLI::App& app);
void add_figure_command(CLI::App& app);
void add_filter_command(CLI::App& app);
void add_measure_command(CLI::App& app);
void add_pockets_command(CLI::App& app);
void add_view_command(CLI::App& app);
