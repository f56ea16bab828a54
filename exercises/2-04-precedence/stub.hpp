#include "rx.hpp"
using namespace rx;

// e with parentheses around each operation: "A|B&!C" -> "(A|(B&(!C)))".
std::string parens(std::string_view e) { todo(); }
