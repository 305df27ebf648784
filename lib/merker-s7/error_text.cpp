#include "error_text.h"

#include "merker_s7.h"

namespace merker::s7client {
namespace {

struct Text {
  int error;
  std::string_view text;
};
constexpr Text kTexts[] = {
    {0, "no error"},
    {errTCPSocketCreation, "the socket cannot be created"},
    {errTCPConnectionTimeout, "the PLC did not answer the connection in time"},
    {errTCPConnectionFailed, "no connection: address not found, or nobody listens at the port"},
    {errTCPReceiveTimeout, "the PLC did not answer in time"},
    {errTCPDataReceive, "data could not be received"},
    {errTCPSendTimeout, "data could not be sent in time"},
    {errTCPDataSend, "data could not be sent"},
    {errTCPConnectionReset, "the PLC closed the connection"},
    {errTCPNotConnected, "not connected"},
    {errIsoConnect, "the PLC refused the connection: wrong rack or slot, or all connections are used"},
    {errIsoInvalidPDU, "the answer is not ISO on TCP (RFC 1006)"},
    {errCliNegotiatingPDU, "the PLC did not accept the setup of the connection"},
    {errCliInvalidParams, "a parameter of the call is invalid"},
    {errCliTooManyItems, "more than 20 items in one call"},
    {errCliInvalidWordLen, "WordLen is invalid, or several bits were asked for"},
    {errCliSizeOverPDU, "the request or its answer is too long for one PDU"},
    {errCliInvalidPlcAnswer, "the answer does not fit the request"},
    {errCliAddressOutOfRange, "the PLC has no such address, or denies the access"},
    {errCliInvalidTransportSize, "the PLC does not know elements of this kind"},
    {errCliWriteDataSizeMismatch, "the length of the data does not fit the element"},
    {errCliItemNotAvailable, "the data block, block or system status list does not exist"},
    {errCliInvalidValue, "the PLC does not accept the value"},
    {errCliCannotStartPLC, "the PLC does not start"},
    {errCliAlreadyRun, "the PLC is in RUN already"},
    {errCliCannotStopPLC, "the PLC does not stop"},
    {errCliCannotCopyRamToRom, "the PLC cannot copy RAM to ROM; it must be in STOP"},
    {errCliCannotCompress, "the PLC cannot compress its memory"},
    {errCliAlreadyStop, "the PLC is in STOP already"},
    {errCliUploadSequenceFailed, "the block could not be fetched: it does not exist, or the PLC broke off"},
    {errCliInvalidBlockNumber, "type or number of the block is invalid"},
    {errCliInvalidBlockSize, "the data are no block"},
    {errCliDownloadSequenceFailed, "the PLC did not take the block"},
    {errCliInsertRefused, "the PLC took the block and does not use it"},
    {errCliDeleteRefused, "the PLC did not delete the block"},
    {errCliBufferTooSmall, "the block is longer than the buffer"},
    {errCliFunNotAvailable, "the PLC does not know this function"},
    {errCliNeedPassword, "the PLC asks for a password"},
    {errCliInvalidPassword, "the password is wrong"},
    {errCliNoPasswordToSetOrClear,
     "the PLC has no password, or it was entered before, or none was entered"},
    {errCliFunctionRefused, "the PLC refused the function"},
    {errLibInvalidObject, "this is not a client"},
};

}  // namespace

std::string_view errorText(int error) {
  for (const Text& row : kTexts)
    if (row.error == error) return row.text;
  return "unknown error";
}

}  // namespace merker::s7client
