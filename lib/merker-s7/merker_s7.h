/* libmerker-s7: reads and writes the inputs, outputs, flags, data blocks, timers and counters of an S7 CPU, or of Merker, over
 * ISO on TCP (RFC 1006). Plain C; names, numbers and layouts are those of Snap7's client where they mean the same, so that a
 * program written for one needs no change of its sources for the other.
 *
 *   S7Object plc = Cli_Create();
 *   uint8_t words[4];
 *   if (Cli_ConnectTo(plc, "192.168.0.10", 0, 2) == 0 && Cli_DBRead(plc, 10, 0, sizeof words, words) == 0) ...
 *   Cli_Destroy(&plc);
 *
 * Values are as the CPU has them: the high byte first. Functions wait for the answer. A client may be used by several threads,
 * which then wait for each other. Each function returns 0 or an error, see Cli_ErrorText.
 */
#ifndef MERKER_S7_H
#define MERKER_S7_H

#include <stdint.h>
#include <time.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

typedef uintptr_t S7Object;

/* Areas */
enum { S7AreaPE = 0x81, S7AreaPA = 0x82, S7AreaMK = 0x83, S7AreaDB = 0x84, S7AreaCT = 0x1C, S7AreaTM = 0x1D };

/* Elements: "WordLen". Start counts bits for S7WLBit, numbers for timers and counters, else bytes. */
enum {
  S7WLBit = 0x01,
  S7WLByte = 0x02,
  S7WLChar = 0x03,
  S7WLWord = 0x04,
  S7WLInt = 0x05,
  S7WLDWord = 0x06,
  S7WLDInt = 0x07,
  S7WLReal = 0x08,
  S7WLCounter = 0x1C,
  S7WLTimer = 0x1D
};

/* Connection resources of the CPU */
enum { CONNTYPE_PG = 1, CONNTYPE_OP = 2, CONNTYPE_BASIC = 3 };

/* Parameters: port (uint16_t, 102), times in milliseconds (int32_t, 3000 to receive, 10 to send, 750 to connect), length of the
 * PDU that is asked for (int32_t, 480). */
enum { p_u16_RemotePort = 2, p_i32_PingTimeout = 3, p_i32_SendTimeout = 4, p_i32_RecvTimeout = 5, p_i32_PDURequest = 10 };

/* Errors: TCP in the low word, then ISO, then the client and the CPU. */
enum {
  errTCPSocketCreation = 0x0001,
  errTCPConnectionTimeout = 0x0002,
  errTCPConnectionFailed = 0x0003,
  errTCPReceiveTimeout = 0x0004,
  errTCPDataReceive = 0x0005,
  errTCPSendTimeout = 0x0006,
  errTCPDataSend = 0x0007,
  errTCPConnectionReset = 0x0008,
  errTCPNotConnected = 0x0009,
  errIsoConnect = 0x00010000,
  errIsoInvalidPDU = 0x00030000,
  errCliNegotiatingPDU = 0x00100000,
  errCliInvalidParams = 0x00200000,
  errCliTooManyItems = 0x00400000,
  errCliInvalidWordLen = 0x00500000,
  errCliSizeOverPDU = 0x00700000,
  errCliInvalidPlcAnswer = 0x00800000,
  errCliAddressOutOfRange = 0x00900000,
  errCliInvalidTransportSize = 0x00A00000,
  errCliWriteDataSizeMismatch = 0x00B00000,
  errCliItemNotAvailable = 0x00C00000,
  errCliInvalidValue = 0x00D00000,
  errCliCannotStartPLC = 0x00E00000,
  errCliAlreadyRun = 0x00F00000,
  errCliCannotStopPLC = 0x01000000,
  errCliCannotCopyRamToRom = 0x01100000,
  errCliCannotCompress = 0x01200000,
  errCliAlreadyStop = 0x01300000,
  errCliFunNotAvailable = 0x01400000,
  errCliUploadSequenceFailed = 0x01500000,
  errCliInvalidBlockNumber = 0x01800000,
  errCliInvalidBlockSize = 0x01900000,
  errCliDownloadSequenceFailed = 0x01A00000,
  errCliInsertRefused = 0x01B00000,
  errCliDeleteRefused = 0x01C00000,
  errCliNeedPassword = 0x01D00000,
  errCliInvalidPassword = 0x01E00000,
  errCliNoPasswordToSetOrClear = 0x01F00000,
  errCliBufferTooSmall = 0x02200000,
  errCliFunctionRefused = 0x02300000,
  errLibInvalidObject = -2
};

/* Types of blocks */
enum {
  Block_OB = 0x38,
  Block_DB = 0x41,
  Block_SDB = 0x42,
  Block_FC = 0x43,
  Block_SFC = 0x44,
  Block_FB = 0x45,
  Block_SFB = 0x46
};

/* States of Cli_GetPlcStatus */
enum { S7CpuStatusUnknown = 0x00, S7CpuStatusRun = 0x08, S7CpuStatusStop = 0x04 };

/* One variable of Cli_ReadMultiVars and Cli_WriteMultiVars; Result is its own error. */
typedef struct {
  int Area;
  int WordLen;
  int Result;
  int DBNumber;
  int Start;
  int Amount;
  void *pdata;
} TS7DataItem, *PS7DataItem;

typedef struct {
  int OBCount, FBCount, FCCount, SFBCount, SFCCount, DBCount, SDBCount;
} TS7BlocksList;

/* The head of a block; dates as "YYYY/MM/DD". */
typedef struct {
  int BlkType, BlkNumber, BlkLang, BlkFlags;
  int MC7Size, LoadSize, LocalData, SBBLength; /* bytes */
  int CheckSum, Version;
  char CodeDate[11], IntfDate[11];
  char Author[9], Family[9], Header[9];
} TS7BlockInfo;

typedef uint16_t TS7BlocksOfType[0x2000];

typedef struct {
  char Code[21];
  uint8_t V1, V2, V3;
} TS7OrderCode;

typedef struct {
  char ModuleTypeName[33], SerialNumber[25], ASName[25], Copyright[27], ModuleName[25];
} TS7CpuInfo;

typedef struct {
  int MaxPduLengt, MaxConnections, MaxMpiRate, MaxBusRate;
} TS7CpInfo;

/* A list of the system status: length of a record and their number, then the records, the high byte first. */
typedef struct {
  uint16_t LENTHDR, N_DR;
} SZL_HEADER;
typedef struct {
  SZL_HEADER Header;
  uint8_t Data[0x4000 - 4];
} TS7SZL;
typedef struct {
  SZL_HEADER Header;
  uint16_t List[0x2000 - 2];
} TS7SZLList;

/* Protection levels by the mode switch, by parameters, the one that counts; positions of the mode switch and the startup switch */
typedef struct {
  uint16_t sch_schal, sch_par, sch_rel, bart_sch, anl_sch;
} TS7Protection;

S7Object Cli_Create(void);
void Cli_Destroy(S7Object *client); /* disconnects; *client becomes 0 */

int Cli_SetConnectionType(S7Object client, uint16_t type); /* CONNTYPE_...; before connecting */
int Cli_ConnectTo(S7Object client, const char *address, int rack, int slot);
int Cli_Connect(S7Object client); /* again, to where it was */
int Cli_Disconnect(S7Object client);
int Cli_GetConnected(S7Object client, int *connected);
int Cli_GetParam(S7Object client, int number, void *value);
int Cli_SetParam(S7Object client, int number, void *value); /* before connecting */
int Cli_GetPduLength(S7Object client, int *requested, int *negotiated);
int Cli_GetLastError(S7Object client, int *error);
int Cli_ErrorText(int error, char *text, int size); /* a sentence, with its zero, in `size` bytes at most */

/* Any length: what one PDU cannot hold is asked in several. `data` has as many bytes as the elements. */
int Cli_ReadArea(S7Object client, int area, int db, int start, int amount, int wordLen, void *data);
int Cli_WriteArea(S7Object client, int area, int db, int start, int amount, int wordLen, void *data);
int Cli_ReadMultiVars(S7Object client, PS7DataItem items, int count);  /* 20 items, one PDU */
int Cli_WriteMultiVars(S7Object client, PS7DataItem items, int count); /* 20 items, one PDU */

/* The same in bytes: data blocks, inputs (E), outputs (A), flags (M); timers and counters in words. */
int Cli_DBRead(S7Object client, int db, int start, int size, void *data);
int Cli_DBWrite(S7Object client, int db, int start, int size, void *data);
int Cli_EBRead(S7Object client, int start, int size, void *data);
int Cli_EBWrite(S7Object client, int start, int size, void *data);
int Cli_ABRead(S7Object client, int start, int size, void *data);
int Cli_ABWrite(S7Object client, int start, int size, void *data);
int Cli_MBRead(S7Object client, int start, int size, void *data);
int Cli_MBWrite(S7Object client, int start, int size, void *data);
int Cli_TMRead(S7Object client, int start, int amount, void *data);
int Cli_TMWrite(S7Object client, int start, int amount, void *data);
int Cli_CTRead(S7Object client, int start, int amount, void *data);
int Cli_CTWrite(S7Object client, int start, int amount, void *data);

/* Blocks as they lie in the CPU, a header of 36 bytes in front. `size`: of `data`, then of the block; Cli_Upload leaves out what is
 * not code or values. A block that is handed over is active at once; number -1: that of its header. */
int Cli_FullUpload(S7Object client, int type, int number, void *data, int *size);
int Cli_Upload(S7Object client, int type, int number, void *data, int *size);
int Cli_Download(S7Object client, int number, void *data, int size);
int Cli_Delete(S7Object client, int type, int number);

/* How many blocks there are, which of a type (*count: of `numbers`, then of the blocks; what is beyond is left out), what the head
 * of one says, in the CPU or in `block`. */
int Cli_ListBlocks(S7Object client, TS7BlocksList *counts);
int Cli_ListBlocksOfType(S7Object client, int type, TS7BlocksOfType *numbers, int *count);
int Cli_GetAgBlockInfo(S7Object client, int type, int number, TS7BlockInfo *info);
int Cli_GetPgBlockInfo(S7Object client, void *block, TS7BlockInfo *info, int size);

/* A whole data block: its values (*size: of `data`, then of the block); the same byte everywhere. */
int Cli_DBGet(S7Object client, int db, void *data, int *size);
int Cli_DBFill(S7Object client, int db, int value);

/* What the CPU is and how it is. *size: of `list` in bytes, then of what it has; *count: numbers likewise. */
int Cli_ReadSZL(S7Object client, int number, int index, TS7SZL *list, int *size);
int Cli_ReadSZLList(S7Object client, TS7SZLList *list, int *count);
int Cli_GetOrderCode(S7Object client, TS7OrderCode *code);
int Cli_GetCpuInfo(S7Object client, TS7CpuInfo *info);
int Cli_GetCpInfo(S7Object client, TS7CpInfo *info);
int Cli_GetProtection(S7Object client, TS7Protection *levels);
int Cli_GetPlcStatus(S7Object client, int *status);

/* The clock of the CPU, as it stands there; the password of the CPU for this connection, 8 characters at most. */
int Cli_GetPlcDateTime(S7Object client, struct tm *time);
int Cli_SetPlcDateTime(S7Object client, struct tm *time);
int Cli_SetPlcSystemDateTime(S7Object client); /* that of this computer, local time */
int Cli_SetSessionPassword(S7Object client, char *password);
int Cli_ClearSessionPassword(S7Object client);

int Cli_PlcHotStart(S7Object client); /* a warm restart on CPUs that have no other one */
int Cli_PlcColdStart(S7Object client);
int Cli_PlcStop(S7Object client);
int Cli_CopyRamToRom(S7Object client, int timeout); /* in STOP; the answer may take so many ms */
int Cli_Compress(S7Object client, int timeout);

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
