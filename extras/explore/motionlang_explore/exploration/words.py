"""What words in names, remarks and printed lines mean, by language: only a first guess, what is played decides.

Each meaning has a pattern for English, German, French, Spanish, Italian, Dutch and Portuguese. A part of a word counts,
but for `\\b`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from motionlang.kernel.lang import Named


def _any(**languages: str) -> str:
    """Return a pattern for the words of any language."""
    return "|".join(languages.values())


def _words(**languages: str) -> re.Pattern[str]:
    return re.compile(_any(**languages), re.IGNORECASE)


# In the name of an input: what resets a fault, what a person pushes, what is on in a good machine, what is there in a
# bad one, what a machine runs by, what sees a part, and what is on while its output is off.
RESET = _words(
    en=r"reset",
    de=r"quit|entst(?:oe|ö)r",
    fr=r"acquit|r[ée]arm",
    es=r"rearme",
    it=r"riarmo|ripristino",
    nl=r"kwiteer|herstel",
)
_ACKNOWLEDGE = _words(en=r"\back", pt=r"\bconfirm")
BY_HAND = _words(
    any=RESET.pattern,
    en=r"start|button|\bp\.?b\b|btn|pedal|palm|hand|foot|finger|\bkey|\back|push(?!er)|changed",
    de=r"tast|knopf|fu(?:ss|ß)",
    fr=r"poussoir|bouton|\bbp\b|p[ée]dale|d[ée]part",
    es=r"pulsador|bot[óo]n|\bmarcha\b|arranque|\bmano",
    it=r"pulsante|avvio|marcia|\bmano\b",
    nl=r"knop|pedaal|\bvoet",
    pt=r"bot[ãa]o|botoeira|partida|\bm[ãa]os?\b",
)
STEADY = _words(
    en=r"stop|guard|door|gate|curtain|cover|hood|\bn\.?/?c\b|closed|shut|\bok\b|ready|\bair|\boil|water|present|health"
    r"|emerg|auto",
    de=r"halt|t(?:ü|ue)r\b|schutz|haube|bereit|luft|druck|vorhanden|geschlossen",
    fr=r"arr[êe]t|urgence|porte|capot|carter|ferm|pression|pr[êe]t|pr[ée]sent|en place",
    es=r"\bparo\b|puerta|resguardo|\btapa\b|\baire|presi[óo]n|listo|cerrad|presente",
    it=r"arresto|porta\b|riparo|griglia|\baria|pressione|pronto|chius|presente",
    nl=r"deur|\bkap\b|\bhek\b|scherm|lucht|gereed|dicht\b|aanwezig",
    pt=r"\bparada|paragem|porta\b|prote[çc][ãa]o|\btampa\b|fechad|press[ãa]o|pronto",
)
ABSENT = _words(
    en=r"open|full|\blow\b|empty|broke|\bbrk\b|\bjam|\bjog|spare|reserve|fault|setup",
    de=r"offen|voll|leer|bruch|tipp",
    fr=r"ouvert|plein|vide|cass|bourr",
    es=r"abiert|llen[oa]\b|\brot[oa]\b|atasc",
    it=r"apert|pien[oa]\b|vuot[oa]\b|rott[oa]\b|esaurit",
    nl=r"\bvol\b|leeg|breuk",
    pt=r"abert|chei[oa]\b|vazi[oa]\b|quebrad|encravad",
)
_RUN = _words(
    en=r"\brun(?:ning)?\b(?! out)",
    de=r"\bbetrieb",
    fr=r"\bmarche\b",
    nl=r"bedrijf",
)
_SEEN = _words(
    en=r"\bseen\b|sensor|detect|\beye\b",
    de=r"erkannt",
    fr=r"d[ée]tect|capteur",
    it=r"rileva",
    nl=r"gezien",
    pt=r"detet",
)
BACK = _words(
    en=r"\bup\b(?! to)|home|\bback|open|retract|releas|raised",
    de=r"oben|zur(?:ü|ue)ck|offen",
    fr=r"haut|arri[èe]re",
    es=r"arriba|atr[áa]s|retra|abiert",
    it=r"\bsu\b|\balto\b|indietro|apert",
    nl=r"boven|terug|achter",
    pt=r"em cima|recuad|abert",
)
# In the name of an output: what only shows something, and what is switched on when something is wrong.
SHOWN = _words(
    en=r"(?<!c)lamp|light|beacon|horn|bell|buzz|siren|green|\bred\b",
    de=r"leuchte|hupe",
    fr=r"voyant|lampe",
    es=r"\bluz\b|l[áa]mpara|piloto|\broj[oa]\b|\bverde\b",
    it=r"spia\b|luce\b|ross[oa]\b",
    nl=r"\brood\b|\bgroen\b|zoemer|toeter",
    pt=r"l[âa]mpada|sinaleir|buzina|campainha|vermelh",
)
ALARM = _words(
    en=r"alarm|(?<!de)fault|trouble|error|fail|reject|scrap(?!er)|\bbad\b|^(?!.*green).*\bred\b"
    r"|\b(?:lamp|light|beacon)\b.*\b(?:out|empty|low)\b",
    de=r"st(?:oe|ö)r(?:ung|[lm])|fehler|ausschu(?:ss|ß)|(?<!gut/)schlecht|\brote?\b",
    fr=r"d[ée]faut|\bpanne|rebut|rouge|mauvais",
    es=r"aver[íi]a|\bfall[oa]s?\b|\broj[oa]\b|rechaz|\bmal[oa]s\b",
    it=r"allarme|guasto|errore|\bross[oa]\b|scart[oi]\b",
    nl=r"storing|\bfout|\brood\b|\brode\b|afkeur|uitval",
    pt=r"avaria|falha|defeito|rejeit|refugo|vermelh",
)
# What calls a person when something is wrong or wanted, or sounds before the machine moves.
SOUND = _words(
    en=r"horn$|siren|buzzer|\bcall\b",
    de=r"hupe|sirene",
    fr=r"klaxon|sir[èe]ne",
    es=r"sirena",
    it=r"sirena",
    nl=r"toeter|zoemer",
    pt=r"buzina|campainha",
)
# Of a level, in a good machine and in a bad one.
GOOD = _words(
    en=r"shut|clos|free|clear|ok|good|in$",
    de=r"zu$|frei|gut",
    fr=r"ferm|libre|bon",
    es=r"cerrad|libre|buen",
    it=r"chius|liber|buon",
    nl=r"dicht|vrij|goed",
    pt=r"fechad|livre",
)
BAD = _words(
    en=r"open|interr|broke|low|empty|stop|halt|fault",
    de=r"offen|unterbr|bruch|leer",
    fr=r"ouv|coup|cass|vide",
    es=r"abiert|cortad|rot[oa]",
    it=r"apert|interrott|rott[oa]",
    nl=r"onderbr|kapot|leeg",
    pt=r"abert|cortad|vazi",
)
# What names of inputs and outputs share by chance.
COMMON = re.compile(
    r"air|and|der|des|for|from|has|inp|input|left|les|off|out|output|part|piece|ready|right|sensor|sol|switch|teil|the"
    r"|valve|when|wire|with"
)
# In a printed line: what is wrong, but for none of it ("0 bad", "no errors", "rejects: 0"), and what there is not ("no
# part").
_TROUBLE = _any(
    en=r"\bbad\b|reject|fail|error|\bfault|trouble|alarm|scrap(?!er)|\bjam|miss(?:ing|ed)|time.?out|\bbroke"
    r"|stuck|hangs|lost|empty|emergency|refus|abort|abandon|g[ai]ven? up|\bheld\b|binned|crack|spoil|\btorn\b"
    r"|(?:thrown|blown|kicked|pushed) (?:o(?:ff|ut)|away)"
    r"|\bout of (?:register|size|range|tolerance|limits?)\b"
    r"|\berr\b|\bflt\b|\balm\b|divert|rework|\brun out|\bwrong|\bwaste|\bnok\b|\btoo\b|\blate\b|\blow\b"
    r"|(?<!under )guard(?=\W*$)|(?:guard|door|hood|lid)(?=\W+(?:is\W+)?(?:open|up|off|not))",
    de=r"\bn\.?i\.?o\b|st(?:oe|ö)rung|fehler|fehlt|ausschu(?:ss|ß)|not-?aus|klemmt|h(?:ae|ä)ngt|gerissen|abbruch"
    r"|(?:t(?:ü|ue)r|haube|schutz\w*)(?=\W+(?:ist\W+)?(?:offen|auf\b))",
    fr=r"d[ée]faut|erreur|rebut|\bpanne\b|manqu|coinc[ée]|bloqu|d[ée]chir|hors (?:tol|lim|cote)"
    r"|(?:carter|capot|porte|grille)(?=\W+(?:est\W+)?ouvert)",
    es=r"aver[íi]a|\bfall[oa]s?\b|\bfalta|\batasc|\brot[oa]s?\b|rechaz|defecto|fuera de"
    r"|(?:puerta|tapa|resguardo)(?=\W+(?:est[áa]\W+)?abiert)",
    it=r"errore|guasto|\bmanca\b|bloccat|inceppat|scart[oi]\b|\brott[oa]\b|allarme|fuori (?:toll|misura)"
    r"|(?:griglia|porta|riparo|carter)(?=\W+(?:è\W+)?apert)",
    nl=r"\bstoring\b|\bfout|ontbreekt|afgekeurd|\bafkeur|\buitval|\bkapot|gebroken|noodstop|klemt\b"
    r"|(?:deur|kap|hek|scherm)(?=\W+(?:is\W+)?open)",
    pt=r"avaria|\bfalha|\bfalta|rejeit|defeito|refugo|encravad|quebrad|(?:porta|tampa|prote[çc][ãa]o)(?=\W+(?:est[áa]\W+)?abert)",
)
_WRONG = re.compile(
    r"(?<!^0 )(?<![^\d.]0 )(?<!\bno )(?<!\bkeine )(?<!\bsin )(?<!\bsem )(?<!\bgeen )"
    rf"(?:{_TROUBLE})(?!\w*\W{{1,12}}0\b(?![.,]\d))"
    rf"|(?:\b(?:not?|keine?|nicht|geen|niet|sin|sem|nessun[oa]?)|n't)\b(?!\W*(?:\d|{_TROUBLE}))",
    re.IGNORECASE,
)
_RIGHT = _words(
    en=r"\bgood\b|\bok\b|complete|\bpass(?:ed)?\b",
    de=r"\bgut",
    fr=r"\bbon(?:ne)?s?\b",
    es=r"\bbuen[oa]s?\b",
    it=r"\bbuon[oaie]\b",
    nl=r"\bgoede?\b",
    pt=r"\bbo(?:m|ns|as?)\b",
)
# What a program says when it stops, but for its start.
_STOPPED = _words(
    en=r"stopped|\bstop (?:pressed|button|key)",
    de=r"angehalten|gestoppt",
    fr=r"arr[êe]t[ée]e?\b",
    es=r"^paro\b|\bparad[oa]\b",
    it=r"\bfermat[oa]\b|arrestat[oa]",
    nl=r"gestopt",
    pt=r"\bparad[oa]\b",
)


def alarms_in(names: Iterable[Named]) -> frozenset[int]:
    """Return the outputs whose names in comments say that something is wrong."""
    return frozenset(
        each.number for each in names if each.kind in ("output", "channel") and ALARM.search(each.name)
    )


def is_pushed(name: str) -> bool:
    """True if a name is that of what a person pushes at work, such as a start button."""
    is_other = is_reset(name) or any(each.search(name) for each in (STEADY, ABSENT, _SEEN))
    return bool(BY_HAND.search(name)) and not is_other


def is_run(name: str) -> bool:
    """True if a name is that of a switch with which a machine runs."""
    return bool(_RUN.search(name)) and not ABSENT.search(name)


def is_reset(name: str) -> bool:
    """True if a name is that of what a person pushes behind a fault."""
    return bool(RESET.search(name) or _ACKNOWLEDGE.search(name))


def is_wrong(said: str) -> bool:
    """True if words say that something is wrong, or that the machine has stopped."""
    return bool(wrong([said])) or has_stopped(said)


def has_stopped(said: str) -> bool:
    """True if words say that the machine has stopped."""
    return bool(_STOPPED.search(said))


def names_alarm(text: str) -> bool:
    """True if a text has a name of something that is on when something is wrong."""
    return bool(ALARM.search(text) or SOUND.search(text))


def speaks(said: str) -> bool:
    """True if a line has words; a number alone may be the code of a fault."""
    return any(map(str.isalpha, said))


def is_right(said: str) -> bool:
    """True if words say that something is right."""
    return bool(_RIGHT.search(said))


def wrong(said: Iterable[str]) -> int:
    """Return how often words say that something is wrong."""
    return sum(len(_WRONG.findall(each)) for each in said)
