"""What a program prints when something is wrong, as a person reads it, in seven languages."""

from __future__ import annotations

import pytest

from motionlang.kernel.lang import Named
from motionlang_explore.exploration import is_wrong
from motionlang_explore.exploration.words import alarms_in

WRONG = """\
mark out of register,  99.2 mm
BORE OUT OF SIZE
ERR 4
FLT 12
STOERUNG Korb 2
Störung Klappe
NOT-AUS
Teil fehlt
Spanner klemmt
Blech haengt
Ausschuss 3
DEFAUT 7 apres 0 tuyaux
défaut bride
erreur 3
rebut
pièce coincée
tapis bloqué
CARTER OUVERT
Schutzhaube offen
torn skin
Batch given up
Fell gerissen
Abbruch 2 an Seite 1
peau déchirée
kein Teil
averia 2, llevamos 3
falta tripa
puerta abierta
pistone bloccato
manca sfoglia
griglia aperta
nessun pezzo
STORING 4
geen hoefijzer
kap open
PARO en fase 40
AVARIA garra
tampa aberta
sem marca
falta cesto
machine arrêtée
macchina fermata
Anlage angehalten
"""
RIGHT = """\
6 out of 10 done
default speed
points coincide
Blech 3 gelaugt und gesalzen
tuyau 3/5 pret
Panel 4
porte fermée
puro no. 4
vaschetta 2 piena: 24 ravioli
keine Störung
para salir pulse paro
geen fouten
sin fallos
hoefijzer 3 klaar
cesto 4 corado
sem avaria
tampa fechada
"""


@pytest.mark.parametrize("text", WRONG.splitlines())
def test_wrong(text: str) -> None:
    assert is_wrong(text)


@pytest.mark.parametrize("text", RIGHT.splitlines())
def test_right(text: str) -> None:
    assert not is_wrong(text)


def test_a_horn_alone_is_no_alarm() -> None:
    """It may sound before each move."""
    named = [
        Named("output", k, name, 1) for k, name in enumerate(("horn", "alarm horn", "fault lamp", "clamp"))
    ]
    assert alarms_in(named) == {1, 2}
