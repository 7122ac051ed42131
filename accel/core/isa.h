#pragma once

/// The instruction set names an inline namespace, so that a plug-in compiled for another one
/// fails to link instead of answering differently.
#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__FMA__)
#define RAYSHOOT_ISA avx512
#elif defined(__AVX2__) && defined(__FMA__)
#define RAYSHOOT_ISA avx2
#elif defined(__FMA__) || defined(__ARM_FEATURE_FMA)
#define RAYSHOOT_ISA fma
#else
#define RAYSHOOT_ISA baseline
#endif
