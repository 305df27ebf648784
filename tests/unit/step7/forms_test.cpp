// Forms that sources of STEP 7 have: heads, declarations, constants, calls. All of them compile
// without a problem.
#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

using List = std::vector<std::string>;

List problemsOf(std::string_view text) { return compileText(text, "generic").problems(); }

TEST(Forms, HeadsOfBlocks) {
  EXPECT_EQ(problemsOf(R"(
FUNCTION_BLOCK FB 41
TITLE ='continuous control'
//
//  closed loop
{ S7_tasklist := 'OB30,OB35'; S7_m_c := 'true'; S7_blockview := 'big' }
AUTHOR:SIMATIC
FAMILY : 'ICONT'
NAME : CONT_C
VERSION : '1.2'
KNOW_HOW_PROTECT
VAR_INPUT
  COM_RST : BOOL  := FALSE;	//complete restart
  TI { S7_visible := 'false'; S7_link := 'true' }: TIME  := T#20S;
END_VAR
VAR
END_VAR
BEGIN
NETWORK
TITLE=no blank
END_FUNCTION_BLOCK
DATA_BLOCK DB 14
TITLE =
{ S7_m_c := 'true' }
VERSION : 0.0
UNLINKED
READ_ONLY
NON_RETAIN
 FB 41
BEGIN
   COM_RST := FALSE; TI := T#1S;
END_DATA_BLOCK
FUNCTION FC1:VOID
STANDARD
CODE_VERSION1
BEGIN
END_FUNCTION;
ORGANIZATION_BLOCK OB1
END_ORGANIZATION_BLOCK // end
)"),
            List{});
}

TEST(Forms, Declarations) {
  EXPECT_EQ(problemsOf(R"(
TYPE UDT 1
VERSION : 0.1
  STRUCT 	
   a : BOOL  := TRUE;	
   c : WORD  := W#16#ABCD; d : DWORD  := DW#16#1234_5678;	
   e : CHAR  := 'x';	
   g : DINT  := L#-2147483648;	
   h : REAL  := -1.5e-10;	
   i : S5TIME  := S5T#1H2M3S;	
   j : TIME  := T#-24D20H31M23S648MS;	
   k : DATE  := D#1990-01-01;	
   l : TIME_OF_DAY  := TOD#23:59:59.999;	
   m : DATE_AND_TIME  := DT#94-5-3-12:30:15.250;	
   n : STRING  [80 ] := '';	
   o : ARRAY  [1 .. 10 ] OF BOOL := TRUE, 9 (FALSE);	
   p : ARRAY  [1 .. 4 ] OF STRUCT 	
     q : INT ;	
    END_STRUCT ;	
   aa : WORD := B#(1,2);
   ab : DWORD := B#(1,2,3,4);
   ac : BYTE := 16#1F;
   ae : BOOL := 1;
   af : BYTE := 2#101;
   ai : DWORD := 'abcd';
   ak : DINT := 100000;
  END_STRUCT ;	
END_TYPE
DATA_BLOCK DB 10
  STRUCT 	
   a : ARRAY [1..100] OF REAL := 100(1.5);
   b : UDT 1;
   f : ARRAY [1..3] OF UDT1;
   g : ARRAY[1..2,-3..4]OF BYTE:=3(B#16#1),4(B#16#2);
  END_STRUCT ;	
BEGIN
   a[1] := 1.000000e+000; 
   b.n := 'a ; and // in it';
   b.p[1].q := 5; 
   f[2].o[3] := TRUE;
   f[3].m := DT#2010-1-1-0:0:0.0;
END_DATA_BLOCK
DATA_BLOCK DB13
UDT1
BEGIN
 a := FALSE;
END_DATA_BLOCK
)"),
            List{});
}

TEST(Forms, Constants) {
  for (const char* constant : {"C#100",
                               "S5T#1H_2M",
                               "S5TIME#500MS",
                               "T#1D_2H_3M_4S_5MS",
                               "T#-1S",
                               "TIME#1s",
                               "TOD#12:30:00.0",
                               "TIME_OF_DAY#10:10:10",
                               "D#1998-4-14",
                               "DATE#1990-1-1",
                               "B#(1,2)",
                               "B#(1, 2, 3, 4)",
                               "2#1010_1010",
                               "'ABCD'",
                               "' '",
                               "'$''",
                               "'a$Lb'",
                               "W#16#FFFF",
                               "w#16#ab_cd",
                               "16#1234",
                               "B#16#1F",
                               "L#-5",
                               "L#+5",
                               "+5",
                               "-5",
                               "1.5",
                               "-1.5e+002",
                               "1.0E5",
                               "P#M 10.0",
                               "P#10.0",
                               "P#DBX 5.0",
                               "P#DIX5.3",
                               "P#E1.0",
                               "P#P 256.0",
                               "P#V 2.0"})
    EXPECT_EQ(problemsOf("FUNCTION FC 1 : VOID\nBEGIN\nL     " + std::string(constant) +
                         "; \nEND_FUNCTION\n"),
              List{})
        << constant;
}

TEST(Forms, StatementsAndCalls) {
  EXPECT_EQ(problemsOf(R"(
FUNCTION FC 1 : VOID
VAR_TEMP
  w : WORD; d : DWORD; i : INT; a : ANY;
END_VAR
BEGIN
NETWORK
TITLE =addresses
      L     DBW [AR1,P#0.0]; 
      T     W [AR1 , P#2.0]; 
      U     DBX [AR2,P#0.0];
      L     PEB [MD 4];
      AUF   DB [#w];
      AUF   DI [LW 0]; 
      L     DBW[#d];
      L     T [MW 4]; 
      LAR1  P##a; 
      TAR1  #d;
      LAR1  ; 
      +AR1  P#2.0; 
      SPL   lst; 
      SPA   M001; 
lst:  SPA   M001; 
M001: BLD   255; 
      U(    
      O     E 0.0; 
      O     ; 
      U     E 0.1; 
      )     
      =     A 0.0
      L     5 ;T MW 2;
      CALL FB 3 , DB10 ();
      CALL  FC     4 (
           IN1                      := TRUE, // one
           IN2                      := MW 10,
           OUT1                     := DB10.DBW 4);
      CALL FC 4
       IN1:=M0.0
       IN2:=MW 10
       OUT1:=#w
      ;
      CALL FC 4 (IN1:=TRUE
        ,IN2:=#i
        ,OUT1:=MW 2);
      UC FC [#w];
      BEA
END_FUNCTION
FUNCTION_BLOCK FB 3
VAR
  x : INT; y : WORD; z : WORD;
END_VAR
BEGIN
END_FUNCTION_BLOCK
FUNCTION FC 4 : VOID
VAR_INPUT
IN1 : BOOL;
IN2 : INT;
END_VAR
VAR_OUTPUT OUT1 : WORD; END_VAR
BEGIN
END_FUNCTION
DATA_BLOCK DB10 FB 3
BEGIN
END_DATA_BLOCK
)"),
            List{});
}

}  // namespace
}  // namespace merker::step7
