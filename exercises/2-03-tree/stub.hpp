#include "rx.hpp"
using namespace rx;

// The spans of node `root`.
Spans eval(const std::vector<Node>& n, int root, const std::vector<Spans>& leaf) { todo(); }
