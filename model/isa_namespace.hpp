#pragma once

/// Code that is compiled once per instruction set lives in an inline namespace of that set's name,
/// so that the linker cannot mix them up.
#ifndef BODYLINE_ISA_NAMESPACE
#define BODYLINE_ISA_NAMESPACE baseline
#endif
