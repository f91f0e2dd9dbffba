#include <iostream>

#include "tests/io/report_support.hpp"

/// Prints the page of a small tuning run, with small pictures, for the test of its view in three
/// dimensions.
int main() { std::cout << bodyline::tests::page_of(bodyline::tests::small_report()); }
