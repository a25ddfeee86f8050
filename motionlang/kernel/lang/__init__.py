"""Common code of the languages: vocabulary, grammars, programs, tasks, scheduler."""
