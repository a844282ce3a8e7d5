#pragma once
/// \file
/// The verbs of the command. Each stands in a file of its own, which adds its options and runs it.
///
/// A verb ends by returning (exit status 0), by `throw CLI::RuntimeError(1)` when a claim or a check failed
/// (and was reported), or by throwing an Error, which becomes one line on standard error and exit status 2.

#include <CLI/CLI.hpp>

namespace plumbline::app {

void add_arm(CLI::App& app);
void add_chain(CLI::App& app);
void add_check(CLI::App& app);
void add_check_experiment(CLI::App& app);
void add_critical(CLI::App& app);
void add_equilibria(CLI::App& app);
void add_figure(CLI::App& app);
void add_new(CLI::App& app);
void add_path(CLI::App& app);
void add_reference(CLI::App& app);
void add_diagnose(CLI::App& app);
void add_serve(CLI::App& app);
void add_trial(CLI::App& app);
void add_verify(CLI::App& app);

}  // namespace plumbline::app
