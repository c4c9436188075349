// SPDX-License-Identifier: BSD-3-Clause
// The program `skyline`: horizons, sky view and shadows of rasters of heights.
#include "Commands.h"
#include "Interrupt.h"
#include "IoFailure.h"
#include "Passes.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

namespace
{

constexpr int RuntimeFailure = 1;
constexpr int WrongUsage = 2;

int Fail(const std::string& reason, int code)
{
  std::fprintf(stderr, "skyline: %s\n", skyline::FirstLine(reason).c_str());
  return code;
}

int Run(int argc, char** argv)
{
  CLI::App program("Horizons, sky view and soft shadows of rasters of heights", "skyline");
  program.set_version_flag("--version", "skyline " SKYLINE_VERSION);
  program.require_subcommand(1);
  program.footer("skyline COMMAND --help tells the options of a command.\n"
                 "Exit status: 0 done; 1 failed, with the reason in one line on standard error and "
                 "no file left; 2 wrong usage.");
  skyline::AddHorizon(program);
  skyline::AddSkyView(program);
  skyline::AddSun(program);
  skyline::AddShadowHeight(program);
  skyline::AddIrradiance(program);
  skyline::AddShade(program);
  skyline::AddView(program);
  skyline::AddBenchmark(program);
  try
  {
    program.parse(argc, argv); // runs the command
  }
  catch (const CLI::Success& wish) // --help, --version
  {
    return program.exit(wish);
  }
  catch (const CLI::ParseError& error)
  {
    return Fail(std::string(error.what()) + " (see skyline --help)", WrongUsage);
  }
  return 0;
}

// Also says what went wrong.
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
