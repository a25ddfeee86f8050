"""What keywords do, one module a subject; a row names its operation as "module.verb"."""
