"""The tables of grammars/mint.lark; written by `python -m motionlang.lang.grammar`, not by hand."""

# ruff: noqa
# mypy: ignore-errors
# fmt: off

from motionlang.lang.tables import Tables
from motionlang.mint.build import *
from motionlang.mint.nodes import *


def _none_0(V, T):
    V.append([])


def _module_1(V, T):
    v0 = V[-1]
    V[-1] = module(v0)


def _auto_2(V, T):
    v0 = V[-1]
    V[-1] = Auto(v0)


def _name_3(V, T):
    v0 = V[-1]
    V[-1] = Name(v0, T[v0])


def _skip_4(V, T):
    V.pop()


def _dotted_5(V, T):
    v0 = V[-1]
    V[-1] = dotted(v0, T[v0])


def _end_6(V, T):
    v0 = V[-1]
    V[-1] = End(v0, None if None is None else T[None])


def _exit_7(V, T):
    v0 = V[-1]
    V[-1] = Exit(v0, "" if None is None else T[None].lower())


def _return_8(V, T):
    v0 = V[-1]
    V[-1] = Return(v0)


def _label_before_9(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = label_before(v0, v1, T)


def _call_10(V, T):
    v0 = V[-1]
    V[-1] = Call(v0.at, v0)


def _body_11(V, T):
    V.append(body(V))


def _plain_one_12(V, T):
    v0 = V[-1]
    V[-1] = [declare(v0)]


def _dim_13(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Dim(v0, v1, None is not None)


def _one_14(V, T):
    v0 = V[-1]
    V[-1] = [v0]


def _end_15(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = End(v0, None if v1 is None else T[v1])


def _exit_16(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Exit(v0, "" if v1 is None else T[v1].lower())


def _gosub_17(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "gosub", T[v1])


def _goto_18(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "goto", T[v1])


def _label_19(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Label(v0, T[v1])


def _character_20(V, T):
    v0 = V[-1]
    V[-1] = Number(v0, ord(string(T[v0])))


def _number_21(V, T):
    v0 = V[-1]
    V[-1] = literal(v0, T[v0])


def _string_22(V, T):
    v0 = V[-1]
    V[-1] = String(v0, string(T[v0]))


def _input_23(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Input(v0, v1, None if None is None else String(None, string(T[None])), None or [], None)


def _bare_call_24(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Call(v0, Name(v0, T[v0], v1))


def _pause_25(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Pause(v0, v1)


def _print_26(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Print(v0, v1 if None is None else [*v1, None], None)


def _run_27(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Run(v0, T[v1])


def _more_28(V, T):
    V.pop()
    v1 = V.pop()
    V[-1].append(v1)


def _name_empty_29(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Name(v0, T[v0], [])


def _dim_30(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Dim(v0, v2, v1 is not None)


def _gosub_31(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "gosub", T[v2])


def _goto_32(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "goto", T[v2])


def _complement_33(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "~", v1)


def _minus_34(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "-", v1)


def _not_35(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "Not", v1)


def _plus_36(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "+", v1)


def _last_item_37(V, T):
    v0 = V[-1]
    V[-1] = PrintItem(v0.at, v0, [], "")


def _print_38(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Print(v0, v1 if v2 is None else [*v1, v2], None)


def _none_39(V, T):
    V[-1] = []


def _member_40(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Member(v0.at, v0, T[v2])


def _next_case_41(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = next_case(v0, v1, v2)


def _assign_42(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Assign(v0.at, v0, v2, None is not None)


def _name_args_43(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Name(v0, T[v0], v2)


def _name_axes_44(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Name(v0, T[v0], v2, True)


def _type_45(V, T):
    v0 = V[-1]
    V[-1] = TypeName(v0, T[v0])


def _const_46(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Const(v0, T[v1], None, v3)


def _define_47(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Define(v0, T[v1], v3)


def _plain_more_48(V, T):
    v2 = V.pop()
    V.pop()
    V[-1].append(declare(v2))


def _more_49(V, T):
    v2 = V.pop()
    V.pop()
    V[-1].append(v2)


def _variable_50(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, v2)


def _valued_variable_51(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, None, v2)


def _more_values_52(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = more_values(v0, v2)


def _parameter_53(V, T):
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], None, False, None is not None)


def _none_54(V, T):
    V.pop()
    V[-1] = []


def _inner_55(V, T):
    V.pop()
    v1 = V.pop()
    V[-1] = v1


def _and_56(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "And", v0, v2)


def _binary_57(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, T[v1], v0, v2)


def _line_if_58(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = If(v0, v1, v3, [])


def _or_59(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Or", v0, v2)


def _xor_60(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Xor", v0, v2)


def _mod_61(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Mod", v0, v2)


def _input_62(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Input(v0, v3, None if v1 is None else String(v1, string(T[v1])), None or [], None)


def _input_63(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Input(v0, v1, None if None is None else String(None, string(T[None])), v3 or [], None)


def _loop_64(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Loop(v0, v2)


def _print_item_65(V, T):
    v2 = V.pop()
    v1 = V.pop()
    V[-1].append(PrintItem(v1.at, v1, [], T[v2]))


def _test_66(V, T):
    v0 = V[-1]
    V[-1] = CaseTest(v0.at, "=", v0)


def _last_case_67(V, T):
    v0 = V[-4]
    v1 = V[-3]
    del V[-3:]
    V[-1] = last_case(v0, v1)


def _assign_68(V, T):
    v0 = V[-4]
    v2 = V[-2]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Assign(v0.at, v0, v2, v3 is not None)


def _parameter_by_reference_69(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v1], None, True, None is not None)


def _parameter_by_value_70(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v1], None, False, None is not None)


def _input_71(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Input(v0, v4, None if None is None else String(None, string(T[None])), None or [], v2)


def _print_72(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Print(v0, v4 if None is None else [*v4, None], v2)


def _last_using_73(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = PrintItem(v0.at, v0, v2, "")


def _repeat_74(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Repeat(v0, v2, v4)


def _select_75(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Select(v0, v2, [v4])


def _startup_76(V, T):
    v0 = V[-5]
    v2 = V[-3]
    del V[-4:]
    V[-1] = Startup(v0, v2)


def _while_77(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v3 = V[-2]
    del V[-4:]
    V[-1] = While(v0, v1, v3)


def _case_else_78(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Case(v0, [], [])


def _case_79(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Case(v0, v1, [])


def _sized_type_80(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = TypeName(v0, T[v0], v2)


def _const_81(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Const(v0, T[v1], v3, v5)


def _typed_variable_82(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = declare(v0, v2, v4)


def _event_83(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = Event(v0, T[v1], v3)


def _parameter_84(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], v2, False, None is not None)


def _parameter_85(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], None, False, v1 is not None)


def _if_86(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = If(v0, v1, v4, v5)


def _line_if_else_87(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = If(v0, v1, v3, v5)


def _input_88(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Input(v0, v3, None if v1 is None else String(v1, string(T[v1])), v5 or [], None)


def _pair_89(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = [v0, v2]


def _print_90(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Print(v0, v4 if v5 is None else [*v4, v5], v2)


def _last_open_91(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = PrintItem(v0.at, v0, [v2], ",")


def _print_using_92(V, T):
    v1 = V[-4]
    v3 = V[-2]
    v4 = V[-1]
    del V[-4:]
    V[-1].append(PrintItem(v1.at, v1, [v3], T[v4]))


def _select_nothing_93(V, T):
    v0 = V[-6]
    v2 = V[-4]
    del V[-5:]
    V[-1] = Select(v0, v2, [])


def _task_94(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = task(v0, T[v1], v3)


def _user_type_95(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = UserType(v0, T[v1], v3)


def _extend_96(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = extended(v0, v1)


def _member_args_97(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    del V[-5:]
    V[-1] = Member(v0.at, v0, T[v2], v4)


def _test_is_98(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = CaseTest(v0, T[v1], v2)


def _test_range_99(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = CaseTest(v0.at, "To", v0, v2)


def _parameter_by_reference_100(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], v3, True, None is not None)


def _parameter_by_reference_101(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], None, True, v2 is not None)


def _parameter_by_value_102(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], v3, False, None is not None)


def _parameter_by_value_103(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], None, False, v2 is not None)


def _function_104(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = Sub(v0, T[v1], v2, v4, True, None)


def _input_105(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = Input(v0, v6, None if v4 is None else String(v4, string(T[v4])), None or [], v2)


def _input_106(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = Input(v0, v4, None if None is None else String(None, string(T[None])), v6 or [], v2)


def _sub_107(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = Sub(v0, T[v1], v2, v4)


def _extend_108(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = extended(v0, v2)


def _parameter_109(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Parameter(v0, T[v0], v4, False, v1 is not None)


def _print_using_two_110(V, T):
    v1 = V[-6]
    v3 = V[-4]
    v5 = V[-2]
    v6 = V[-1]
    del V[-6:]
    V[-1].append(PrintItem(v1.at, v1, [v3, v5], T[v6]))


def _for_111(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v3 = V[-6]
    v5 = V[-4]
    v7 = V[-2]
    del V[-8:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, None, v7), None, T)


def _parameter_by_reference_112(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Parameter(v0, T[v1], v5, True, v2 is not None)


def _parameter_by_value_113(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Parameter(v0, T[v1], v5, False, v2 is not None)


def _function_114(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    del V[-8:]
    V[-1] = Sub(v0, T[v1], v2, v6, True, v4)


def _third_115(V, T):
    v2 = V[-2]
    del V[-3:]
    V[-1] = v2


def _input_116(V, T):
    v0 = V[-9]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    v8 = V[-1]
    del V[-8:]
    V[-1] = Input(v0, v6, None if v4 is None else String(v4, string(T[v4])), v8 or [], v2)


def _for_117(V, T):
    v0 = V[-10]
    v1 = V[-9]
    v3 = V[-7]
    v5 = V[-5]
    v7 = V[-3]
    v9 = V[-1]
    del V[-9:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, None, v7), v9, T)


def _for_118(V, T):
    v0 = V[-11]
    v1 = V[-10]
    v3 = V[-8]
    v5 = V[-6]
    v7 = V[-4]
    v9 = V[-2]
    del V[-10:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, v7, v9), None, T)


def _else_if_119(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = [If(v0, v1, v4, v5)]


def _for_120(V, T):
    v0 = V[-12]
    v1 = V[-11]
    v3 = V[-9]
    v5 = V[-7]
    v7 = V[-5]
    v9 = V[-3]
    v11 = V[-1]
    del V[-11:]
    V[-1] = counted(For(v0, Name(v1, T[v1]), v3, v5, v7, v9), v11, T)


TOKEN = '(?:[ \t]+)?((?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++|(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

CONTINUED = '(?:[ \t]+|[\\\\_][ \t]*+(?:\'[^\n]*+)?\n)*((?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++|(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

LITERALS = {
    '!': 'COMPLEMENT',
    '#': 'HASH',
    '%': 'PERCENT',
    '&': 'AMPERSAND',
    '(': 'LPAR',
    ')': 'RPAR',
    '*': 'STAR',
    '+': 'PLUS',
    ',': 'COMMA',
    '-': 'MINUS',
    '.': 'DOT',
    '/': 'DIVIDE',
    ':': 'COLON',
    ';': 'SEMICOLON',
    '<': 'COMPARE',
    '<<': 'SHIFT',
    '<=': 'COMPARE',
    '<>': 'COMPARE',
    '=': 'EQUAL',
    '>': 'COMPARE',
    '>=': 'COMPARE',
    '>>': 'SHIFT',
    '?': 'QMARK',
    '[': 'LSQB',
    '\\': 'DIVIDE',
    ']': 'RSQB',
    '^': 'CIRCUMFLEX',
    'and': 'AND',
    'as': 'AS',
    'auto': 'AUTO',
    'byref': 'BYREF',
    'byval': 'BYVAL',
    'case': 'CASE',
    'const': 'CONST',
    'define': 'DEFINE',
    'dim': 'DIM',
    'do': 'DO',
    'else': 'ELSE',
    'elseif': 'ELSEIF',
    'end': 'END',
    'endif': 'ENDIF',
    'endl': 'ENDL',
    'endloop': 'ENDLOOP',
    'endw': 'ENDW',
    'endwhile': 'ENDWHILE',
    'event': 'EVENT',
    'exit': 'EXIT',
    'for': 'FOR',
    'function': 'FUNCTION',
    'gosub': 'GOSUB',
    'goto': 'GOTO',
    'if': 'IF',
    'input': 'INPUT',
    'is': 'IS',
    'loop': 'LOOP',
    'mod': 'MOD',
    'next': 'NEXT',
    'not': 'NOT',
    'nv': 'NV',
    'or': 'OR',
    'pause': 'PAUSE',
    'print': 'PRINT',
    'repeat': 'REPEAT',
    'return': 'RETURN',
    'run': 'RUN',
    'select': 'SELECT',
    'startup': 'STARTUP',
    'step': 'STEP',
    'sub': 'SUB',
    'task': 'TASK',
    'then': 'THEN',
    'to': 'TO',
    'type': 'TYPE',
    'until': 'UNTIL',
    'using': 'USING',
    'wend': 'WEND',
    'while': 'WHILE',
    'xor': 'XOR',
    '|': 'VBAR',
    '~': 'COMPLEMENT',
}

CLASSES = {
    '_NL': "(?:(?:'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++",
    'NAME': '(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])',
    'DOTTED': '[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++',
    'NUMBER': '(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])',
    'STRING': '"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"',
    'CHARACTER': '`(?:[^`\\\\\n]|\\\\[^\n])`',
}

SPELLINGS = {
    'MOD': 'Mod',
    'AND': 'And',
    'AS': 'As',
    'AUTO': 'Auto',
    'BYREF': 'ByRef',
    'BYVAL': 'ByVal',
    'CASE': 'Case',
    'CONST': 'Const',
    'DEFINE': 'Define',
    'DIM': 'Dim',
    'DO': 'Do',
    'ELSE': 'Else',
    'ELSEIF': 'ElseIf',
    'END': 'End',
    'ENDIF': 'EndIf',
    'ENDL': 'EndL',
    'ENDLOOP': 'EndLoop',
    'ENDW': 'EndW',
    'ENDWHILE': 'EndWhile',
    'EVENT': 'Event',
    'EXIT': 'Exit',
    'FOR': 'For',
    'FUNCTION': 'Function',
    'GOSUB': 'GoSub',
    'GOTO': 'GoTo',
    'IF': 'If',
    'INPUT': 'Input',
    'IS': 'Is',
    'LOOP': 'Loop',
    'NEXT': 'Next',
    'NOT': 'Not',
    'NV': 'NV',
    'OR': 'Or',
    'PAUSE': 'Pause',
    'PRINT': 'Print',
    'REPEAT': 'Repeat',
    'RETURN': 'Return',
    'RUN': 'Run',
    'SELECT': 'Select',
    'STARTUP': 'Startup',
    'STEP': 'Step',
    'SUB': 'Sub',
    'TASK': 'Task',
    'THEN': 'Then',
    'TO': 'To',
    'TYPE': 'Type',
    'UNTIL': 'Until',
    'USING': 'Using',
    'WEND': 'Wend',
    'WHILE': 'While',
    'XOR': 'Xor',
    'COLON': ':',
    'LPAR': '(',
    'RPAR': ')',
    'COMMA': ',',
    'STAR': '*',
    'SEMICOLON': ';',
    'HASH': '#',
    'EQUAL': '=',
    'QMARK': '?',
    'MINUS': '-',
    'PLUS': '+',
    'LSQB': '[',
    'RSQB': ']',
    'DOT': '.',
    'PERCENT': '%',
    'CIRCUMFLEX': '^',
    'VBAR': '|',
    'AMPERSAND': '&',
}

RULES = (
    (0, 'items', _none_0),
    (1, 'start', _module_1),
    (1, 'inline_statement', _auto_2),
    (1, 'leading', None),
    (1, 'name{leading}', _name_3),
    (2, 'items', _skip_4),
    (1, 'axes', _dotted_5),
    (1, 'inline_statement', _end_6),
    (1, 'leading', None),
    (1, 'inline_statement', _exit_7),
    (1, 'leading', None),
    (1, 'name{NAME}', _name_3),
    (0, 'print_list', _none_0),
    (1, 'inline_statement', _return_8),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'items', _label_before_9),
    (1, 'target', None),
    (1, 'call', None),
    (1, 'inline_statement', _call_10),
    (1, 'ref{name{NAME}}', None),
    (1, 'call', None),
    (1, 'target', None),
    (1, 'target', None),
    (0, 'body', _body_11),
    (1, 'declared', _name_3),
    (1, 'leading', None),
    (1, 'dims', None),
    (1, 'closed_dims', _plain_one_12),
    (2, 'inline_statement', _dim_13),
    (1, 'dims', None),
    (1, 'closed_dims', _one_14),
    (1, 'open_dims', _one_14),
    (2, 'inline_statement', _end_15),
    (2, 'inline_statement', _exit_16),
    (0, 'parameters', _none_0),
    (2, 'inline_statement', _gosub_17),
    (2, 'inline_statement', _goto_18),
    (2, 'inline_statement', _label_19),
    (1, 'name{word}', _name_3),
    (1, 'operand', _character_20),
    (1, 'operand', _number_21),
    (1, 'operand', _string_22),
    (1, 'or{atom}', None),
    (1, 'term{atom}', None),
    (1, 'bit_or{atom}', None),
    (1, 'not{atom}', None),
    (1, 'bit_and{atom}', None),
    (1, 'variable', None),
    (1, 'expr', None),
    (1, 'compare{atom}', None),
    (1, 'shift{atom}', None),
    (1, 'sum{atom}', None),
    (2, 'inline_statement', _input_23),
    (1, 'or{operand}', None),
    (1, 'term{operand}', None),
    (2, 'inline_statement', _bare_call_24),
    (1, 'bit_or{operand}', None),
    (1, 'not{operand}', None),
    (1, 'bit_and{operand}', None),
    (1, 'bare', _one_14),
    (1, 'compare{operand}', None),
    (1, 'shift{operand}', None),
    (1, 'sum{operand}', None),
    (2, 'inline_statement', _pause_25),
    (2, 'inline_statement', _print_26),
    (2, 'inline_statement', _run_27),
    (3, 'items', _more_28),
    (3, 'items', _more_28),
    (3, 'items', _more_28),
    (3, 'items', _more_28),
    (3, 'items', _more_28),
    (3, 'name{leading}', _name_empty_29),
    (1, 'exprs', _one_14),
    (3, 'inline_statement', _dim_30),
    (3, 'inline_statement', _gosub_31),
    (3, 'inline_statement', _goto_32),
    (2, 'unary{atom}', _complement_33),
    (2, 'unary{atom}', _minus_34),
    (2, 'not{atom}', _not_35),
    (2, 'unary{atom}', _plus_36),
    (2, 'unary{operand}', _complement_33),
    (3, 'name{NAME}', _name_empty_29),
    (2, 'unary{operand}', _minus_34),
    (2, 'not{operand}', _not_35),
    (2, 'unary{operand}', _plus_36),
    (1, 'print_last', _last_item_37),
    (3, 'inline_statement', _print_38),
    (0, 'task_body', _body_11),
    (1, 'seps', _none_39),
    (0, 'members', _none_0),
    (3, 'ref{name{leading}}', _member_40),
    (3, 'ref{name{NAME}}', _member_40),
    (2, 'body', _skip_4),
    (2, 'body', _label_before_9),
    (3, 'select_head', _next_case_41),
    (3, 'inline_statement', _assign_42),
    (4, 'name{leading}', _name_args_43),
    (4, 'name{leading}', _name_axes_44),
    (1, 'type', _type_45),
    (4, 'inline_statement', _const_46),
    (4, 'inline_statement', _define_47),
    (3, 'closed_dims', _plain_more_48),
    (3, 'closed_dims', _more_49),
    (3, 'open_dims', _more_49),
    (3, 'typed', _variable_50),
    (3, 'valued', _valued_variable_51),
    (3, 'open_dims', _more_values_52),
    (3, 'closed_dims', _more_49),
    (3, 'open_dims', _more_49),
    (1, 'parameter', _parameter_53),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'parameters', _none_54),
    (1, 'parameter_list', _one_14),
    (3, 'name{word}', _name_empty_29),
    (3, 'atom', _inner_55),
    (3, 'and{atom}', _and_56),
    (3, 'power{atom}', _binary_57),
    (3, 'bit_and{atom}', _binary_57),
    (3, 'bit_or{atom}', _binary_57),
    (3, 'compare{atom}', _binary_57),
    (3, 'compare{atom}', _binary_57),
    (1, 'closed', _one_14),
    (1, 'line_tail', None),
    (1, 'closed', None),
    (1, 'inline', _one_14),
    (1, 'line_tail', _one_14),
    (4, 'line_if', _line_if_58),
    (3, 'ref{name{word}}', _member_40),
    (3, 'or{atom}', _or_59),
    (3, 'or{atom}', _xor_60),
    (3, 'shift{atom}', _binary_57),
    (3, 'sum{atom}', _binary_57),
    (3, 'sum{atom}', _binary_57),
    (3, 'term{atom}', _binary_57),
    (3, 'term{atom}', _mod_61),
    (3, 'term{atom}', _mod_61),
    (3, 'term{atom}', _binary_57),
    (4, 'inline_statement', _input_62),
    (4, 'inline_statement', _input_62),
    (1, 'formats', _one_14),
    (4, 'inline_statement', _input_63),
    (1, 'end_loop', None),
    (1, 'end_loop', None),
    (4, 'inline_statement', _loop_64),
    (4, 'name{NAME}', _name_args_43),
    (4, 'name{NAME}', _name_axes_44),
    (3, 'and{operand}', _and_56),
    (3, 'power{operand}', _binary_57),
    (3, 'bare', _more_49),
    (3, 'bit_and{operand}', _binary_57),
    (3, 'bit_or{operand}', _binary_57),
    (3, 'compare{operand}', _binary_57),
    (3, 'compare{operand}', _binary_57),
    (3, 'or{operand}', _or_59),
    (3, 'or{operand}', _xor_60),
    (3, 'shift{operand}', _binary_57),
    (3, 'sum{operand}', _binary_57),
    (3, 'sum{operand}', _binary_57),
    (3, 'term{operand}', _binary_57),
    (3, 'term{operand}', _mod_61),
    (3, 'term{operand}', _mod_61),
    (3, 'term{operand}', _binary_57),
    (3, 'print_list', _print_item_65),
    (3, 'print_list', _print_item_65),
    (2, 'seps', _skip_4),
    (1, 'test', _test_66),
    (1, 'tests', _one_14),
    (4, 'select', _last_case_67),
    (3, 'body', _more_28),
    (3, 'body', _more_28),
    (3, 'body', _more_28),
    (4, 'inline_statement', _assign_68),
    (3, 'exprs', _more_49),
    (4, 'declared', _name_args_43),
    (2, 'parameter', _parameter_by_reference_69),
    (2, 'parameter', _parameter_by_value_70),
    (3, 'parameters', _inner_55),
    (4, 'name{word}', _name_args_43),
    (4, 'name{word}', _name_axes_44),
    (5, 'inline_statement', _input_71),
    (2, 'end_loop', _skip_4),
    (5, 'inline_statement', _print_72),
    (3, 'print_last', _last_using_73),
    (5, 'inline_statement', _repeat_74),
    (5, 'select_head', _select_75),
    (5, 'declaration', _startup_76),
    (2, 'task_body', _skip_4),
    (2, 'task_body', _label_before_9),
    (1, 'member_list', _one_14),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (5, 'inline_statement', _while_77),
    (3, 'case', _case_else_78),
    (3, 'case', _case_79),
    (3, 'type', _sized_type_80),
    (6, 'inline_statement', _const_81),
    (5, 'valued', _typed_variable_82),
    (6, 'declaration', _event_83),
    (3, 'parameter', _parameter_84),
    (3, 'parameter', _parameter_85),
    (3, 'parameter_list', _more_49),
    (1, 'end_if', None),
    (1, 'if_tail', _none_39),
    (6, 'statement', _if_86),
    (6, 'statement', _if_86),
    (6, 'line_if', _line_if_else_87),
    (3, 'closed', _more_49),
    (3, 'inline', _more_49),
    (3, 'line_tail', _more_49),
    (6, 'inline_statement', _input_88),
    (6, 'inline_statement', _input_88),
    (3, 'formats', _pair_89),
    (6, 'inline_statement', _print_90),
    (4, 'print_last', _last_open_91),
    (5, 'print_list', _print_using_92),
    (6, 'select', _select_nothing_93),
    (6, 'declaration', _task_94),
    (3, 'task_body', _more_28),
    (3, 'task_body', _more_28),
    (3, 'task_body', _more_28),
    (3, 'task_body', _more_28),
    (3, 'task_body', _more_28),
    (6, 'declaration', _user_type_95),
    (3, 'members', _extend_96),
    (3, 'members', _extend_96),
    (2, 'end_while', _skip_4),
    (6, 'ref{name{leading}}', _member_args_97),
    (6, 'ref{name{NAME}}', _member_args_97),
    (3, 'test', _test_is_98),
    (3, 'test', _test_is_98),
    (3, 'test', _test_range_99),
    (3, 'tests', _more_49),
    (4, 'parameter', _parameter_by_reference_100),
    (4, 'parameter', _parameter_by_reference_101),
    (4, 'parameter', _parameter_by_value_102),
    (4, 'parameter', _parameter_by_value_103),
    (7, 'routine', _function_104),
    (2, 'else_if', _skip_4),
    (2, 'end_if', _skip_4),
    (6, 'ref{name{word}}', _member_args_97),
    (7, 'inline_statement', _input_105),
    (7, 'inline_statement', _input_105),
    (7, 'inline_statement', _input_106),
    (7, 'routine', _sub_107),
    (4, 'members', _extend_108),
    (4, 'members', _extend_108),
    (3, 'member_list', _more_49),
    (5, 'parameter', _parameter_109),
    (7, 'print_list', _print_using_two_110),
    (7, 'print_list', _print_using_two_110),
    (9, 'inline_statement', _for_111),
    (6, 'parameter', _parameter_by_reference_112),
    (6, 'parameter', _parameter_by_value_113),
    (9, 'routine', _function_114),
    (4, 'if_tail', _third_115),
    (6, 'closed_if', _line_if_else_87),
    (9, 'inline_statement', _input_116),
    (9, 'inline_statement', _input_116),
    (10, 'inline_statement', _for_117),
    (11, 'inline_statement', _for_118),
    (6, 'if_tail', _else_if_119),
    (6, 'if_tail', _else_if_119),
    (12, 'inline_statement', _for_120),
)

ROWS = (
    '1=items 2=start d0',
    '3=AUTO 4=BYREF,BYVAL,NV,STEP,TO,USING,leading 5=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 11=EVENT 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 28=STARTUP 29=SUB 30=TASK 31=TYPE 32=WHILE 33=_NL 34=axes 35=call 36=declaration,routine 37=inline_statement,select,statement 38=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target d1',
    '',
    'r2=COLON,ELSE,_NL d3',
    '44=LPAR 45=LSQB d4',
    'd5',
    '46=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '47=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 49=NV 50=closed_dims 51=declared 52=dims 53=open_dims 54=typed 55=valued',
    'd6',
    '56=NAME d7',
    '57=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d8',
    '58=EVENT,FOR,FUNCTION,LOOP,REPEAT,SELECT,SUB,TASK,WHILE,exit_kind d9',
    '59=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '60=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '61=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 62=HASH',
    '63=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 64=HASH',
    '65=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 80=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 86=HASH 87=STRING 88=axes,variable 81=name{word},ref{name{word}} d10',
    '89=COLON,_NL,sep',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 90=COMPLEMENT 9=DOTTED 91=LPAR 92=LSQB 93=MINUS 94=NOT 72=NUMBER 95=PLUS 74=STRING 96=and{operand},not{operand} 97=axes,operand,power{operand},unary{operand},variable 98=bare 99=bit_and{operand} 100=bit_or{operand} 101=compare{operand} 81=name{word},ref{name{word}} 102=or{operand} 103=shift{operand} 104=sum{operand} 105=term{operand} d11',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 106=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '107=HASH 108=print_list d12',
    '109=COLON,_NL,sep',
    'd13',
    '110=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d14',
    '111=CASE',
    '112=COLON,_NL,sep d15',
    '113=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '114=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d16',
    '115=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d17',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 116=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd18',
    'r19=EQUAL d20',
    'd21',
    '117=COLON 118=_NL',
    '119=COLON 120=_NL',
    '121=_NL',
    'r22=DOT,EQUAL d23',
    '122=DOT d24',
    '123=DOT d25',
    '124=body d26',
    '125=EQUAL',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 126=RPAR 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 128=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 129=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '130=AS 131=EQUAL',
    '132=EQUAL',
    '133=LPAR d27',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 50=closed_dims 51=declared 134=dims 53=open_dims 54=typed 55=valued d28',
    '135=COMMA d29',
    '136=AS 137=EQUAL d30',
    'd31',
    '138=COMMA d32',
    'd33',
    'd34',
    'd35',
    '139=COLON,_NL,sep',
    'd36',
    '140=EQUAL',
    '141=LPAR 142=parameters d37',
    'd38',
    '143=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd39',
    '144=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd40',
    '145=LPAR 146=LSQB d41',
    'd42',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 147=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 148=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 149=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 150=not{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd43',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 151=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    'd44',
    '152=AND d45',
    '153=CIRCUMFLEX d46',
    '154=AMPERSAND d47',
    '155=VBAR d48',
    '156=COMPARE 157=EQUAL d49',
    '158=DO 159=THEN',
    '160=DOT d50',
    '161=OR 162=XOR d51',
    '163=SHIFT d52',
    '164=MINUS 165=PLUS d53',
    '166=DIVIDE 167=MOD 168=PERCENT 169=STAR d54',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 170=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '171=COMMA 172=SEMICOLON',
    '173=USING d55',
    '174=body d26',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 175=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 176=RPAR 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 177=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 178=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 179=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 180=not{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 181=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '182=AND d56',
    '183=CIRCUMFLEX d57',
    '184=COMMA d58',
    '185=AMPERSAND d59',
    '186=VBAR d60',
    '187=COMPARE 188=EQUAL d61',
    '189=OR 190=XOR d62',
    '191=SHIFT d63',
    '192=MINUS 193=PLUS d64',
    '194=DIVIDE 195=MOD 196=PERCENT 197=STAR d65',
    'd66',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 198=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 199=expr 81=name{word},ref{name{word}} 82=or{atom} 200=print_last 83=shift{atom} 84=sum{atom} 85=term{atom} d67',
    '201=body d26',
    'd68',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 202=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '203=body d26',
    '141=LPAR 204=parameters d37',
    '205=COLON,_NL,sep',
    '206=COLON,_NL,sep 207=seps',
    '208=COLON,_NL,sep',
    'd69',
    'd70',
    'd71',
    'd72',
    'd73',
    '209=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '210=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 211=CASE 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 213=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 215=case 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 218=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd74',
    'd75',
    '219=COMMA 220=RPAR',
    '219=COMMA 221=RSQB',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 223=type',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 224=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 225=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 226=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd76',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 227=declared 228=typed 229=valued',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 230=type',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 231=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '232=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 233=declared 81=name{word},ref{name{word}} 234=shift{atom} 84=sum{atom} 85=term{atom} 235=typed 236=valued',
    '237=body d26',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 238=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '239=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 240=BYREF 241=BYVAL 242=RPAR 243=parameter 244=parameter_list',
    '245=AS 246=COLON,_NL,sep',
    'd77',
    'd78',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 247=RPAR 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 248=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 249=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd79',
    '250=RPAR',
    'd80',
    'd81',
    'd82',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 251=not{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 252=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 253=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 254=bit_and{atom} 79=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 255=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 256=shift{atom} 84=sum{atom} 85=term{atom}',
    '257=COLON,_NL,sep',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 258=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 259=_NL 34=axes 35=call 260=closed 261=closed_if 262=inline 263=inline_statement,select 264=line_if 265=line_tail 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '266=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 267=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 268=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 269=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 270=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 271=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 272=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 273=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 274=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 275=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '276=COMMA',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 277=axes,variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 278=axes,variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 279=expr 280=formats 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 281=END 282=ENDL 283=ENDLOOP 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 284=end_loop 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    'd83',
    'd84',
    '219=COMMA 285=RPAR',
    '219=COMMA 286=RSQB',
    'd85',
    'd86',
    'd87',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 287=not{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 288=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 289=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 290=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 291=bit_and{atom} 79=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 292=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 293=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 294=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 295=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 81=name{word},ref{name{word}} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 296=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 297=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 76=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}} 298=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 299=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 300=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 301=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 302=atom,axes,operand,power{atom},unary{atom},variable 81=name{word},ref{name{word}}',
    '303=COMMA',
    '304=COMMA 305=SEMICOLON 306=USING d88',
    'd89',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 307=UNTIL 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '206=COLON,_NL,sep 308=seps',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 309=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '310=COLON,_NL,sep',
    '311=task_body d90',
    'd91',
    '312=COLON,_NL,sep 313=members d92',
    '314=body d26',
    '315=LPAR d93',
    '316=LPAR d94',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 317=ELSE 318=IS 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 319=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom} 320=test 321=tests',
    'd95',
    '56=NAME 322=SELECT d7',
    'd96',
    'd97',
    '323=COLON 324=_NL',
    '325=_NL',
    '219=COMMA 326=SEMICOLON d98',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 327=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd99',
    'd100',
    '328=STAR d101',
    '329=EQUAL',
    'd102',
    'd103',
    '219=COMMA 330=RPAR',
    '136=AS 137=EQUAL d104',
    'd105',
    'd106',
    '331=EQUAL d107',
    'd108',
    'r27=AS,EQUAL 332=LPAR 146=LSQB d41',
    '136=AS 137=EQUAL',
    '163=SHIFT d109',
    'd110',
    'd111',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 333=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '334=TO',
    '335=AS 336=LPAR d112',
    '337=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d113',
    '338=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d114',
    'd115',
    'd116',
    '339=COMMA 340=RPAR',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 341=type',
    '342=body d26',
    'd117',
    '219=COMMA 343=RPAR',
    '219=COMMA 344=RSQB',
    'd118',
    'd119',
    'd120',
    '156=COMPARE 157=EQUAL d121',
    '154=AMPERSAND d122',
    '163=SHIFT d123',
    '163=SHIFT d124',
    '345=body d26',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 346=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '347=body d26',
    '348=ELSE',
    'd125',
    '349=COLON r126=_NL d127',
    'd128',
    'd129',
    'd130',
    '350=LPAR d131',
    '152=AND d132',
    '152=AND d133',
    '164=MINUS 165=PLUS d134',
    '166=DIVIDE 167=MOD 168=PERCENT 169=STAR d135',
    '166=DIVIDE 167=MOD 168=PERCENT 169=STAR d136',
    '153=CIRCUMFLEX d137',
    '153=CIRCUMFLEX d138',
    '153=CIRCUMFLEX d139',
    '153=CIRCUMFLEX d140',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 351=STRING 352=axes,variable 81=name{word},ref{name{word}}',
    '353=USING d141',
    '354=USING d142',
    '355=COMMA d143',
    'd144',
    '356=LOOP 56=NAME d7',
    'd145',
    'd146',
    'd147',
    'd148',
    'd149',
    'd150',
    'd151',
    'd152',
    '156=COMPARE 157=EQUAL d153',
    '154=AMPERSAND d154',
    '163=SHIFT d155',
    '163=SHIFT d156',
    '152=AND d157',
    '152=AND d158',
    '164=MINUS 165=PLUS d159',
    '166=DIVIDE 167=MOD 168=PERCENT 169=STAR d160',
    '166=DIVIDE 167=MOD 168=PERCENT 169=STAR d161',
    '153=CIRCUMFLEX d162',
    '153=CIRCUMFLEX d163',
    '153=CIRCUMFLEX d164',
    '153=CIRCUMFLEX d165',
    '357=print_list d12',
    'd166',
    'd167',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 358=expr 359=formats 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 360=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '211=CASE 312=COLON,_NL,sep 361=END 362=case',
    '56=NAME 363=STARTUP d7',
    '364=body d26',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 365=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 366=END 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 29=SUB 32=WHILE 367=_NL 34=axes 35=call 368=inline_statement,select,statement 369=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 370=routine 42=select_head 43=target',
    'd168',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 371=DIM 372=END 373=declared 374=member_list 375=typed',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 376=END 377=ENDW 378=ENDWHILE 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 379=WEND 32=WHILE 214=_NL 34=axes 35=call 380=end_while 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 381=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 382=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '383=COLON,_NL,sep',
    '384=COMPARE 385=EQUAL',
    '386=TO d169',
    'd170',
    '387=COLON,_NL,sep 388=COMMA',
    'd171',
    'd172',
    'd173',
    'd174',
    'd175',
    'd176',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 72=NUMBER 73=PLUS 74=STRING 389=atom,axes,operand,unary{atom},variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 390=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd177',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 391=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 247=RPAR 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 392=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '393=EVENT 56=NAME d7',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 394=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 395=type',
    '396=RPAR',
    '397=AS 398=LPAR d178',
    '399=AS 400=LPAR d179',
    '239=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 240=BYREF 241=BYVAL 401=parameter',
    'd180',
    '402=COLON,_NL,sep',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 403=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    'd181',
    'd182',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 404=ELSE 405=ELSEIF,else_if 406=END 407=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 408=end_if 409=if_tail 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '410=THEN',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 404=ELSE 405=ELSEIF,else_if 406=END 407=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 408=end_if 411=if_tail 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 412=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 413=inline 263=inline_statement,select 264=line_if 414=line_tail 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 258=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 415=closed_if 416=inline_statement,select 417=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 127=expr 418=exprs 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '419=COMMA 420=SEMICOLON',
    '421=USING d183',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 279=expr 422=formats 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 279=expr 423=formats 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 424=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd184',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 199=expr 81=name{word},ref{name{word}} 82=or{atom} 425=print_last 83=shift{atom} 84=sum{atom} 85=term{atom} d185',
    '426=COMMA 427=SEMICOLON d143',
    'd186',
    'd187',
    '428=SELECT',
    'd188',
    'd189',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 429=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    'd190',
    '56=NAME 430=TASK d7',
    'd191',
    '431=COLON 432=_NL',
    '433=_NL',
    '434=COLON 435=_NL',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 373=declared 436=member_list 375=typed',
    '437=TYPE',
    '438=AS',
    '439=COLON 440=COMMA 441=_NL',
    'd192',
    '56=NAME 442=WHILE d7',
    'd193',
    'd194',
    'd195',
    'd196',
    '219=COMMA 443=RPAR',
    '219=COMMA 444=RPAR',
    'd197',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 445=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 446=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 447=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd198',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 318=IS 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 319=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom} 448=test',
    'd199',
    'd200',
    'd201',
    '219=COMMA 449=RPAR',
    'd202',
    '450=COLON,_NL,sep 451=STEP',
    'd203',
    '452=AS d204',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 453=type',
    '454=RPAR',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 455=type',
    '456=RPAR',
    'd205',
    '457=body d26',
    '458=FUNCTION 56=NAME d7',
    '459=COLON,_NL,sep 460=IF',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 461=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '462=IF 56=NAME d7',
    'd206',
    'd207',
    'd208',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 258=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 463=closed 261=closed_if 262=inline 263=inline_statement,select 264=line_if 265=line_tail 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    'd209',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 464=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '465=COLON d126',
    'd210',
    'd211',
    'd212',
    'd213',
    '219=COMMA 466=RPAR',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 467=axes,variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 468=axes,variable 81=name{word},ref{name{word}}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 279=expr 469=formats 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd214',
    'd215',
    'd216',
    'd217',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 470=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom} d218',
    'd219',
    'd220',
    '56=NAME 471=SUB d7',
    'd221',
    'd222',
    'd223',
    'd224',
    'd225',
    'd226',
    '472=COLON 440=COMMA 473=_NL',
    'd227',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 474=type',
    'd228',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 373=declared 475=typed',
    'd229',
    'd230',
    'd231',
    'd232',
    'd233',
    'd234',
    'd235',
    'd236',
    'r177=AS,EQUAL d181',
    '476=body d26',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 477=expr 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 478=type',
    'd237',
    '479=AS d238',
    'd239',
    '480=AS d240',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 481=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    'd241',
    '482=body d26',
    'd242',
    '483=DO 484=THEN',
    'd243',
    '485=ELSE',
    '486=THEN',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 412=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 416=inline_statement,select 417=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    'd244',
    '487=USING d245',
    '488=USING d246',
    'd247',
    '489=COMMA 490=SEMICOLON d216',
    'd248',
    'd249',
    'd250',
    'd107',
    'd251',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 491=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '492=COLON,_NL,sep',
    'd252',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 493=type',
    '222=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 494=type',
    '495=FUNCTION 56=NAME d7',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 406=END 407=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 496=end_if 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '497=COLON,_NL,sep',
    '498=COLON,_NL,sep',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 258=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 499=closed 261=closed_if 262=inline 263=inline_statement,select 264=line_if 414=line_tail 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 258=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 260=closed 261=closed_if 262=inline 263=inline_statement,select 264=line_if 265=line_tail 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 279=expr 500=formats 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    '66=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 67=CHARACTER 68=COMPLEMENT 9=DOTTED 69=LPAR 70=MINUS 71=NOT 72=NUMBER 73=PLUS 74=STRING 75=and{atom},not{atom} 76=atom,axes,operand,power{atom},unary{atom},variable 77=bit_and{atom} 78=bit_or{atom} 79=compare{atom} 279=expr 501=formats 81=name{word},ref{name{word}} 82=or{atom} 83=shift{atom} 84=sum{atom} 85=term{atom}',
    'd253',
    'd254',
    '502=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d255',
    '503=body d26',
    'd256',
    'd257',
    'd258',
    'd259',
    '504=body d26',
    '505=body d26',
    'd260',
    'd261',
    'd262',
    'd263',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 506=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 404=ELSE 405=ELSEIF,else_if 406=END 407=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 408=end_if 507=if_tail 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 212=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 404=ELSE 405=ELSEIF,else_if 406=END 407=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 214=_NL 34=axes 35=call 408=end_if 508=if_tail 216=inline_statement,select,statement 217=line_if 39=name{NAME} 40=name{leading},ref{name{leading}} 41=ref{name{NAME}} 42=select_head 43=target',
    '509=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d264',
    'd265',
    'd266',
    'd267',
)

TABLES = Tables(TOKEN, CONTINUED, LITERALS, CLASSES, RULES, ROWS, 2)
