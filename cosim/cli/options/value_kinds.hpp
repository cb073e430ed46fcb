// What the value of an option or of an argument is. CLI11 gets it as the name of the type. The help and the man page
// show it, and shells complete values by it. A value of any other kind keeps the name that CLI11 gives it.
#pragma once

namespace armature::cosim {

inline constexpr const char* kFileValue = "FILE";
inline constexpr const char* kFolderValue = "DIR";
inline constexpr const char* kScenarioValue = "SCENARIO";  // a name, a folder or a file
inline constexpr const char* kRobotValue = "ROBOT";        // a name or a file

}  // namespace armature::cosim
