// The commands of the program `armature`. Each takes what the command line gave and returns the exit code:
// 0 ok, 1 a check failed (golden, expectation, invariant), 2 bad input, 3 internal, 130 interrupted.
// Bad input is thrown as InputError and reported by cli_main. `path`: where bare names are looked up.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cosim/scenario/search_path.hpp"

namespace armature::cosim {

inline constexpr int kExitOk = 0;
inline constexpr int kExitCheckFailed = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInternal = 3;
inline constexpr int kExitInterrupted = 130;

struct RunArguments {
  std::string scenario;                      // folder, scenario.toml, or a name from `armature list`
  std::optional<std::filesystem::path> out;  // default out/<scenario>
  std::optional<std::filesystem::path> vcd;
  std::optional<std::filesystem::path> fst;
  std::optional<double> from_s;
  std::optional<double> to_s;
  bool wave_on_fault = false;
  std::vector<std::string> set;       // key=value
  std::optional<std::string> fabric;  // "rtl" | "paper" instead of the scenario's own
  std::optional<std::string> serial;  // pty, pty:LINK, tcp:PORT, replay:FILE
};
int run_command(const RunArguments& arguments, const SearchPath& path);

struct CheckArguments {
  std::vector<std::string> scenarios;  // or folders of scenarios; empty: all of the user's, else of the program
  int jobs = 1;
  std::filesystem::path out = "out/check";  // the results of those that fail, each in a folder of its name
  std::optional<std::filesystem::path> junit;
};
int check_command(const CheckArguments& arguments, const SearchPath& path);

struct CompareArguments {
  std::filesystem::path a;
  std::filesystem::path b;
};
int compare_command(const CompareArguments& arguments);

struct BlessArguments {
  std::string scenario;
};
int bless_command(const BlessArguments& arguments, const SearchPath& path);

struct FkArguments {
  std::string robot;                // name from `armature list`, or a path ending in .toml
  std::vector<std::string> joints;  // one pose: angles [deg] as written; otherwise empty
  std::optional<std::string> in;    // a file of joints; "-" is standard input
  std::string out = "-";            // "-" is standard output
};
int fk_command(const FkArguments& arguments, const SearchPath& path);

struct IkArguments {
  std::string robot;
  std::vector<std::string> xyz, rpy;  // one pose: mm and deg as written; otherwise empty
  std::vector<std::string> previous;  // with it: joints [deg] before; empty: all 0
  std::optional<std::string> in;      // a file of poses
  std::string out = "-";
};
// One pose: kExitCheckFailed when the arm cannot take it.
int ik_command(const IkArguments& arguments, const SearchPath& path);

struct ServeArguments {
  std::string listen;                        // tcp:PORT, or the path of a Unix socket
  std::optional<std::filesystem::path> out;  // folder for waveforms; without it clients may write none
  bool paper_fabric = false;                 // the variant of the logic
};
// Serves until Ctrl-C: kExitInterrupted. kExitCheckFailed when an assertion inside the logic failed.
int serve_command(const ServeArguments& arguments);

// kExitBadInput when a file cannot be read, or when there is nothing to list.
int list_command(const SearchPath& path);
int info_command(const SearchPath& path);

}  // namespace armature::cosim
