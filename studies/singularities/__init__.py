"""The study of singularities: g with a floor on paths that cross none to three of them, against log(1 / ε)."""
