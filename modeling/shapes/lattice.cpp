#include "modeling/shapes/lattice.h"
