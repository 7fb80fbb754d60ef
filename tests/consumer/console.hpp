#pragma once

/// Writes a text to where the program's console is: host.cpp or cortex_m4/start.cpp has it.
void write(const char* text);
