// The commands: each function adds one to the application, with its options and what it does.
#pragma once

#include <CLI/CLI.hpp>

#include "program/exit_code.hpp"

namespace retiarius::program {

// The command writes to `code`, which must outlive the parsing, when it ends otherwise than well
// without an exception.
void add_run_command(CLI::App& app, ExitCode& code);
void add_resume_command(CLI::App& app, ExitCode& code);
void add_validate_command(CLI::App& app);
void add_new_command(CLI::App& app);
void add_info_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_view_command(CLI::App& app);
void add_render_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_docs_command(CLI::App& app);
void add_bench_command(CLI::App& app);
void add_campaign_command(CLI::App& app, ExitCode& code);
void add_converge_command(CLI::App& app, ExitCode& code);
void add_check_contact_command(CLI::App& app, ExitCode& code);
void add_verify_command(CLI::App& app, ExitCode& code);

}  // namespace retiarius::program
