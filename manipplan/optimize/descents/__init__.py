"""One descent: models of g and of distances about a path, the rows of its limits and clearances, and the trust region."""
