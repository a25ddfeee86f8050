"""The answers to a probe, read from the output of a terminal, and their meaning."""

from __future__ import annotations

import re
from dataclasses import dataclass

from motionlang.commands.probe.assumption import REFUSED, Assumption, Probe
from motionlang.commands.probe.probe import BEGIN, END, FIRST_MARK, MARKS, NEXT, mark
from motionlang.commands.probe.questions import questions
from motionlang.kernel import Diagnostic
from motionlang.kernel.lang import ASSUMPTIONS, switch
from motionlang.kernel.tools import count_of

NUMBER = r"(?P<number>[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)"
_ESCAPE = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|[\x00-\x09\x0b\x0c\x0e-\x1f\x7f]")
_STAMP = re.compile(r"^\s*\[?(?:\d{4}-\d\d-\d\d[ T])?\d{1,2}:\d\d:\d\d(?:[.,]\d+)?\]?[ \t]*")
_MINT = re.compile(r"(?<!\")<([a-z]+(?:\.[a-z0-9-]+)?)\|([^<>\n]*)(>?)")
_MARK = re.compile(rf"{str(FIRST_MARK)[:3]}\d{{6}}")
# The difference of a value from the chosen one that still counts as equal.
ROUNDING = 1e-9
# The placeholder of an axis or of a distance in a question, its brackets escaped.
_FILLED = re.compile(r"\\\{\w+\\\}")
HOLDS, OTHER, UNKNOWN = "holds", "other", "unknown"


@dataclass(eq=False, slots=True)
class AnswerVerdict:
    """The result of an answer for an assumption: `holds`, `other` or `unknown`.

    `other` means that an alternative applies: `what` describes it, and `value` is the setting for it. `unknown` means
    that the answer matches no alternative.
    """

    assumption: Assumption
    answer: str
    status: str
    what: str
    value: object = None

    @property
    def can_be_set(self) -> bool:
        """True if a machine file can make the virtual controller give the same answer."""
        return self.value is not None


class Answers:
    """The results: `verdicts` in the order of the assumptions, and `problems`.

    The problems refer to lines of the output.
    """

    def __init__(self) -> None:
        self.language = ""
        self.verdicts: list[AnswerVerdict] = []
        self.problems: list[Diagnostic] = []

    def complain(self, message: str, hint: str = "", line: int = 0, severity: str = "error") -> None:
        """Add an error in the answers to the problems."""
        self.problems.append(Diagnostic("answers", message, line, hint=hint, severity=severity))


def read(text: str, wanted: str = "") -> Answers:
    """Return the answers in a terminal's output.

    `wanted` is the required language of the probe, "" for any.
    """
    found = Answers()
    lines = [_STAMP.sub("", line) for line in _ESCAPE.sub("", re.sub(r"\r\n?", "\n", text)).split("\n")]
    answered = _answers_of_mint(lines, found)
    if answered:
        found.language = "mint"
    else:
        answered = _answers_of_mccl(lines, found)
        found.language = "mccl" if answered else ""
    if not answered:
        what = (
            "the questions are here, and no answers"
            if _is_a_probe(text)
            else "there is no answer to a probe here"
        )
        found.complain(what, "run the probe on the controller, and keep what its terminal shows")
        return found
    if wanted and wanted != found.language:
        hint = f"motionlang probe {found.language} --answers reads them"
        found.complain(f"these are the answers to a probe of {found.language}, not of {wanted}", hint)
        return found
    _verdict_of(found, answered)
    return found


def _is_a_probe(text: str) -> bool:
    return f"<{BEGIN}|" in text or str(mark(BEGIN)) in text


# -------------------------------------------------------------------------------------------- finding answers


def _answers_of_mint(lines: list[str], found: Answers) -> dict[str, list[tuple[str, int]]]:
    """Return the answers by name, with their line numbers.

    A listing of the probe in the output is not mistaken for answers: there a quote follows the name.
    """
    answered: dict[str, list[tuple[str, int]]] = {}
    for number, line in enumerate(lines, 1):
        for match in _MINT.finditer(line):
            name, answer, closed = match.groups()
            if '"' in answer:
                continue
            if closed:
                answered.setdefault(name, []).append((_plain(answer), number))
            elif name in questions():
                found.complain(f"the answer to {name} is cut off", line=number)
    return answered


def _answers_of_mccl(lines: list[str], found: Answers) -> dict[str, list[tuple[str, int]]]:
    """Return the answers by name: the text after each mark, without the echo."""
    names = {mark(name): name for name in (*questions(), BEGIN, END, NEXT)}
    answered: dict[str, list[tuple[str, int]]] = {}
    name, begun = "", 0
    chunks: list[str] = []
    for number, line in enumerate(lines, 1):
        stripped = line.strip()
        if stripped.startswith(">"):
            rest = stripped.lstrip("> ")
            stripped = rest if _MARK.fullmatch(rest) else ""
        if _MARK.fullmatch(stripped) and FIRST_MARK <= int(stripped) < FIRST_MARK + MARKS:
            if name and name != NEXT:
                answered.setdefault(name, []).append((_plain(" ".join(chunks)), begun))
            name, chunks, begun = names.get(int(stripped), f"question {stripped}"), [], number
        elif stripped and not _is_echo(stripped, name):
            chunks.append(stripped)
    if name == END:
        answered[name] = [("", begun)]
    elif name in questions():
        found.complain(f"the answer to {name} is cut off", line=begun)
    return answered


def _is_echo(line: str, name: str) -> bool:
    """True if a line without a prompt is an echo of the input."""
    if _MARK.search(line) or line.startswith(";"):
        return True
    assumption = questions().get(name)
    return (
        assumption is not None
        and assumption.probe is not None
        and any(letter.isalpha() for letter in line)
        and re.fullmatch(_FILLED.sub(r"[-+.\\de]+", re.escape(assumption.probe.ask)), line) is not None
    )


def _plain(answer: str) -> str:
    return " ".join(answer.split())


# ----------------------------------------------------------------------------------------- evaluating answers


def _verdict_of(found: Answers, answered: dict[str, list[tuple[str, int]]]) -> None:
    begin, end = answered.pop(BEGIN, []), answered.pop(END, [])
    known = {
        name
        for name, each in questions().items()
        if each.probe is not None and each.probe.language == found.language
    }
    order = {name: rank for rank, name in enumerate(questions())}
    for name, answers in answered.items():
        if name not in known:
            other = "a reading of the other language" if name in questions() else "no reading"
            found.complain(f"{name} is {other}", "was the probe written by another version?", answers[0][1])
        elif len({answer for answer, _ in answers}) > 1:
            says = " and ".join(repr(answer) for answer, _ in answers[:2])
            found.complain(f"{name} is answered twice, by {says}", "keep one of them", answers[1][1])
        else:
            answer, line = answers[0]
            _take(found, questions()[name], answer, line)
    found.verdicts.sort(key=lambda each: order[each.assumption.name])
    count = re.search(r"\d+", begin[0][0]) if begin else None
    got = sum(name in known for name in answered)
    if all(each.answer == REFUSED for each in found.verdicts) and found.verdicts:
        return
    if not begin or not end:
        what = "beginning" if not begin else "end"
        found.complain(f"the {what} of the answers is missing: {got} were found", "what is here counts")
    elif count is not None and int(count[0]) > got:
        missing = int(count[0]) - got
        found.complain(
            f"{missing} of {count[0]} questions have no answer", "what is here counts", severity="warning"
        )


def _take(found: Answers, assumption: Assumption, answer: str, line: int) -> None:
    try:
        verdict = result_of(assumption, answer)
    except ValueError as problem:
        found.complain(f"{assumption.name}: {problem}", "nothing is set for it", line)
        return
    found.verdicts.append(verdict)


def result_of(assumption: Assumption, answer: str) -> AnswerVerdict:
    """Return the verdict on an answer; ValueError for a number that cannot be set."""
    probe = assumption.probe
    assert probe is not None
    settable = switch(assumption.name)
    if probe.form:
        value, chosen = _number(probe, answer), _number(probe, probe.answers[0])
        if value is None or chosen is None:
            return AnswerVerdict(assumption, answer, UNKNOWN, "")
        if abs(value - chosen) <= ROUNDING * abs(chosen):
            return AnswerVerdict(assumption, answer, HOLDS, assumption.chosen)
        if settable is not None and (wrong := settable.problem(value)):
            raise ValueError(f"the answer {answer!r} is a value that {wrong}")
        return AnswerVerdict(assumption, answer, OTHER, f"{value:.10g}", value if assumption.key else None)
    fits = [n for n, each in enumerate(probe.answers) if is_answer(each, answer)]
    if fits == [0]:
        return AnswerVerdict(assumption, answer, HOLDS, assumption.chosen)
    if len(fits) != 1:
        return AnswerVerdict(assumption, answer, UNKNOWN, "")
    other = assumption.alternatives[fits[0] - 1]
    return AnswerVerdict(
        assumption, answer, OTHER, other, settable.choices[fits[0]] if settable is not None else None
    )


def _number(probe: Probe, answer: str) -> float | None:
    """Return the value in an answer, None if the answer has another form.

    Integers are returned as such.
    """
    match = re.fullmatch(probe.form.replace("{}", NUMBER), answer)
    if match is None:
        return None
    groups = match.groupdict()
    value = (
        float(len(groups["decimals"])) if "decimals" in groups else float(groups["number"])
    ) * probe.scale
    return int(value) if value == int(value) else float(f"{value:.10g}")


def is_answer(expected: str, answer: str) -> bool:
    """True if an answer is the expected one.

    It is compared as a pattern, or word by word, with numbers compared by value.
    """
    if expected.startswith("re:"):
        return re.fullmatch(expected[3:], answer) is not None
    wanted, given = expected.split(), answer.split()
    return len(wanted) == len(given) and all(map(_are_equal, wanted, given))


def _are_equal(wanted: str, given: str) -> bool:
    """True if numbers differ by at most half a unit of the last digit shown."""
    if wanted == given:
        return True
    if not (re.fullmatch(NUMBER, wanted) and re.fullmatch(NUMBER, given)):
        return False
    decimals = (
        min(len(each.lower().partition("e")[0].partition(".")[2]) for each in (wanted, given) if "." in each)
        if ("." in wanted and "." in given)
        else 9
    )
    return abs(float(wanted) - float(given)) <= 0.5000001 * 10.0**-decimals + 1e-6 * abs(float(wanted)) * (
        "e" in given
    )


def machine_text(found: Answers, source: str) -> str:
    """Return the `[readings]` of a machine file that reproduce the answers."""
    count = {
        status: sum(each.status == status for each in found.verdicts) for status in (HOLDS, OTHER, UNKNOWN)
    }
    hold, do, fit = (count[status] for status in (HOLDS, OTHER, UNKNOWN))
    lines = [
        (
            f"# Answers of a controller in {source}: "
            f"{count_of(hold, 'assumption confirmed', 'assumptions confirmed')}, {do} refuted, "
            f"{count_of(fit, 'answer')} unknown."
        )
    ]
    others = [each for each in found.verdicts if each.status == OTHER]
    own = [each for each in others if each.can_be_set and each.assumption.key.startswith(ASSUMPTIONS)]
    if own:
        lines += ["", "[assumptions]"]
        lines += [
            f'"{each.assumption.name}" = {_toml_value(each.value)}  # {each.assumption.question}'
            for each in own
        ]
    for each in others:
        if each.can_be_set and each not in own:
            table, _, key = each.assumption.key.rpartition(".")
            lines += ["", f"[{table}]", f"{key} = {_toml_value(each.value)}  # {each.assumption.question}"]
    fixed = [each for each in others if not each.can_be_set]
    if fixed:
        lines += ["", "# Also refuted, but without a key to set:"]
        lines += [f"# {each.assumption.name}: {each.what} (answered {each.answer})" for each in fixed]
    return "\n".join(lines) + "\n"


def _toml_value(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else f"{value!r}"
