#include "source/symbol_table.h"
