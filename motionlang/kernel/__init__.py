"""The parts that run a program: source, languages, controller, planners, servo and log.

    text ─► tree ─► check ─► steps ─► task ─► scheduler ─► verbs ─► profiles ─► log ─► report

`execution.run` goes this way, from a `Source` to a `Run`. Two languages, `mint` and `mccl`, become steps, which tasks
of `lang` carry out. They call the verbs of one `controller`, whose moves become closed-form profiles of `planners` on a
virtual clock. The `log` has what happened. A result depends on the program and its machine alone: no real time, no
randomness, no order of a hash.

Every house reads what the kernel makes. The kernel imports no house, except where `pyproject.toml` lists it.
"""
