// SPDX-License-Identifier: BSD-3-Clause
// The program `skyline`: horizons, sky view, shadows and light of DEMs.
#include "Commands.h"
#include "Failure.h"
#include "Interrupt.h"
#include "IoFailure.h"
#include "RunPass.h"
#include "Shared/NearName.h"
#include "Values.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace
{

constexpr int RuntimeFailure = 1;
constexpr int UsageFailure = 2;

int Fail(const std::string& reason, int code)
{
  std::fprintf(stderr, "skyline: %s\n", skyline::FirstLine(reason).c_str());
  return code;
}

/// The error message for an empty value, for instance of a shell variable that is not set.
std::string WhyEmpty(const std::string& text)
{
  return text.empty()
    ? "the value is empty (a variable that is not set?); give one, or leave it out"
    : "";
}

// Returns the option that is written `--name=` without a value, for which CLI11 would take the next
// word; empty if there is none.
std::string EmptyOption(int argc, char** argv)
{
  for (int k = 1; k < argc && std::strcmp(argv[k], "--") != 0; ++k)
  {
    const std::string word = argv[k];
    if (word.rfind("--", 0) == 0 && word.find('=') == word.size() - 1)
    {
      return word.substr(0, word.size() - 1);
    }
  }
  return "";
}

void RefuseEmptyValues(CLI::App& program)
{
  for (CLI::App* command : program.get_subcommands({}))
  {
    for (CLI::Option* option : command->get_options())
    {
      if (option->get_items_expected_max() > 0) // not a flag
      {
        // This check comes before all others.
        option->transform(CLI::Validator([](std::string& text) { return WhyEmpty(text); }, ""));
      }
    }
  }
}

// Returns what is wrong with words that no option has taken; empty if there are none.
std::string WhyExtra(const CLI::App& program, const CLI::App* command)
{
  const std::vector<std::string> extra = (command ? *command : program).remaining();
  const auto option = std::find_if(
    extra.begin(), extra.end(), [](const std::string& word) { return word.rfind('-', 0) == 0; });
  std::vector<std::string> names;
  if (!command && !extra.empty() && option != extra.begin())
  {
    for (const CLI::App* known : program.get_subcommands({}))
    {
      names.push_back(known->get_name());
    }
    return "there is no command " + extra[0] + skyline::DidYouMean(extra[0], names);
  }
  if (option != extra.end())
  {
    const std::string word = option->substr(0, option->find('='));
    for (const CLI::Option* known : (command ? *command : program).get_options())
    {
      for (const std::string& name : known->get_lnames())
      {
        names.push_back("--" + name);
      }
    }
    return word + " is no option" + (command ? " of " + command->get_name() : "") +
      skyline::DidYouMean(word, names);
  }
  return extra.empty() ? "" : extra[0] + " is one word too many";
}

int Run(int argc, char** argv)
{
  CLI::App program(
    "Computes horizons, sky view, shadows and light of digital elevation models (DEMs)", "skyline");
  program.set_version_flag("--version", "skyline " SKYLINE_VERSION);
  program.require_subcommand(1);
  program.footer(
    "skyline COMMAND --help lists the options of a command.\n"
    "Exit status: 0: success; 1: failure, with the reason in one line on standard error and no\n"
    "output file left; 2: wrong usage.");
  skyline::AddHorizon(program);
  skyline::AddSkyView(program);
  skyline::AddSun(program);
  skyline::AddShadowHeight(program);
  skyline::AddIrradiance(program);
  skyline::AddShade(program);
  skyline::AddView(program);
  skyline::AddBenchmark(program);
  RefuseEmptyValues(program);
  const auto refuse = [&](const std::string& reason)
  {
    const auto chosen = program.get_subcommands(
      [&](const CLI::App* known) { return argc > 1 && known->get_name() == argv[1]; });
    const std::string command = chosen.empty() ? "" : " " + chosen[0]->get_name();
    return Fail(reason + " (see skyline" + command + " --help)", UsageFailure);
  };
  try
  {
    const std::string empty = EmptyOption(argc, argv);
    if (!empty.empty())
    {
      return refuse(empty + ": " + WhyEmpty(""));
    }
    program.parse(argc, argv); // also runs the command
  }
  catch (const CLI::Success& request) // --help, --version
  {
    return program.exit(request);
  }
  catch (const CLI::ParseError& error)
  {
    const auto chosen = program.get_subcommands();
    const std::string extra = WhyExtra(program, chosen.empty() ? nullptr : chosen[0]);
    return refuse(extra.empty() ? error.what() : extra);
  }
  catch (const skyline::WrongUsage& error)
  {
    return refuse(error.what());
  }
  return 0;
}

// Runs the program and prints its errors. Returns the exit status.
int StatusOf(int argc, char** argv)
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::bad_alloc&)
  {
    return Fail("not enough memory", RuntimeFailure);
  }
  catch (const std::exception& error)
  {
    return Fail(error.what(), RuntimeFailure);
  }
}

} // namespace

int main(int argc, char** argv)
{
  skyline::CatchInterrupts();
  const int status = StatusOf(argc, argv);
  skyline::EndIfInterrupted();
  return status;
}
