#ifndef continua_theory_arb_headers_h
#define continua_theory_arb_headers_h

// What Continua uses of Arb, which is a library of its own beside FLINT 2 and a part of FLINT 3.
#if __has_include(<flint/acb_hypgeom.h>)
#include <flint/acb.h>
#include <flint/acb_hypgeom.h>
#include <flint/arb.h>
#include <flint/arf.h>
#else
#include <acb.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <arf.h>
#endif

#endif
