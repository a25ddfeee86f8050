"""Evidence: the source of each fact about a keyword, and the assumptions made where the sources are silent.

They are data, in the files of this package. `help`, `check --evidence`, the hover of an editor and the pages of the
documentation read them; a run never does.
"""
