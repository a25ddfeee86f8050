"""An axis of an MCCL board: units and mode, its inputs and limits, its status words, its motor."""
