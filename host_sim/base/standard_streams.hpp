#pragma once
#include <string>

namespace spanline::sim {

/// Makes streams that the caller has closed exist, so that no file that is opened takes their place, and lets writes
/// beyond the limit on file sizes fail instead of ending the process.
void prepare_streams();

/// Prints to stdout what the user asked to see. It has left the process when this returns. Throws Failure.
void print(const std::string& text);

/// A line on stderr: "spanline: KIND: TEXT". One line whatever the text holds: file names may have control characters.
void print_message(const std::string& kind, std::string text);

}  // namespace spanline::sim
