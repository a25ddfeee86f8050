"""What the languages share: vocabulary, grammar tables, programs, tasks and the scheduler."""
