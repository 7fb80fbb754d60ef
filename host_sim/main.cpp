#include "commands/commands.hpp"

int main(int argc, char** argv) { return spanline::sim::run_command_line(argc, argv); }
