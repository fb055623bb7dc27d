// Carries the precompiled header: main.cpp cannot, since it defines Catch's implementation.
#include <catch2/catch.hpp>
