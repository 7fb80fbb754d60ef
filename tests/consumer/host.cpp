#include <cstdio>

#include "console.hpp"

void write(const char* text) { std::fputs(text, stdout); }
